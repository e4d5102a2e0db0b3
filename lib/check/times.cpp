// Cycle and monitoring times are counted in one byte of governor main cycles (manual 7.1.3, D8).
#include <fmt/format.h>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"

namespace cgw::check {

namespace {

using parameter::Device;

struct TimeRange {
    std::uint16_t first;
    int count;
    std::string_view section;
};

constexpr TimeRange time_ranges[] = {
    {config::governor::tpdo_cycle, config::tpdo_count - config::first_analogue_tpdo + 1, "7.1.3"},
    {config::governor::rpdo_monitoring, config::rpdo_count, "7.1.5"},
};

void check_time(const Context& context, std::uint16_t number, std::string_view section) {
    const parameter::Assignment* assignment = usable(context, Device::governor, number);
    if (assignment == nullptr || assignment->value > config::longest_time_ms) {
        return;
    }
    const double main_cycle_us = context.configuration.main_cycle_us;
    const double limit_us = (config::maximum_governor_cycles + 1) * main_cycle_us;
    if (assignment->value * 1000 < limit_us) {
        return;
    }
    const auto asked_ms = static_cast<std::uint32_t>(assignment->value);
    const auto longest_ms = static_cast<std::uint32_t>((limit_us - 1) / 1000);
    context.findings.report(
        {.rule = &diagnostic::rules::time_too_long,
         .message = fmt::format("{} is {} ms, {} main cycles of {} ms; at most {} are possible (manual {})",
                                label(context, Device::governor, number), asked_ms,
                                config::cyclic_time(asked_ms, context.configuration.main_cycle_us).cycles,
                                main_cycle_us / 1000, config::maximum_governor_cycles, section),
         .where = assignment->where,
         .help = fmt::format("{} ms is the longest time that works", longest_ms)});
}

}  // namespace

void check_times(const Context& context) {
    for (const TimeRange& range : time_ranges) {
        for (int offset = 0; offset < range.count; ++offset) {
            check_time(context, static_cast<std::uint16_t>(range.first + offset), range.section);
        }
    }
}

}  // namespace cgw::check
