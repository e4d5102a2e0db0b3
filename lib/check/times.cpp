// Cycle and monitoring times are counted in whole main cycles (manual 7.1.3, 7.1.5, 7.2.3; D8).
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "check/monitoring.hpp"
#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"

namespace cgw::check {

namespace {

using config::CyclicTime;
using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

struct TimeRange {
    std::uint16_t first;
    std::uint16_t last;
    std::string_view section;
};

constexpr TimeRange time_ranges[] = {
    {governor::tpdo_cycle, governor::last_tpdo_cycle, "7.1.3"},
    {governor::rpdo_monitoring, governor::last_rpdo_monitoring, "7.1.5"},
};

void check_time(const Context& context, std::uint16_t number, std::string_view section) {
    const Assignment* assignment = usable(context, Device::governor, number);
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
        {.rule = &rules::time_too_long,
         .message = fmt::format("{} is {} ms, {} main cycles of {} ms; at most {} are possible (manual {})",
                                label(context, Device::governor, number), asked_ms,
                                config::cyclic_time(asked_ms, context.configuration.main_cycle_us).cycles,
                                main_cycle_us / 1000, config::maximum_governor_cycles, section),
         .where = assignment->where,
         .help = fmt::format("{} ms is the longest time that works", longest_ms)});
}

std::string_view section_of(Device device, std::uint16_t number) {
    const bool of_rpdo = number >= governor::rpdo_monitoring;
    return device == Device::gateway ? "7.2.3" : of_rpdo ? "7.1.5" : "7.1.3";
}

}  // namespace

void check_times(const Context& context) {
    for (const TimeRange& range : time_ranges) {
        for (std::uint16_t number = range.first; number <= range.last; ++number) {
            check_time(context, number, range.section);
        }
    }
}

void check_quantised_times(const Context& context) {
    const std::vector<Watch> all = watches(context);
    for (const config::Decision& decision : context.configuration.decisions) {
        if (decision.kind != config::DecisionKind::quantised) {
            continue;
        }
        const Assignment* assignment = sound(context, decision.device, decision.parameter);
        const bool has_warning = std::any_of(all.begin(), all.end(), [&](const Watch& watch) {
            return watch.device == decision.device && watch.number == decision.parameter && watch.active &&
                   (watch.is_short() || config::trips_early(watch.time));
        });
        if (assignment == nullptr || has_warning) {
            continue;
        }
        const CyclicTime& time = decision.time;
        context.findings.report(
            {.rule = &rules::time_quantised,
             .message = fmt::format("{} is {} ms, in effect {}: {} main cycle{} of the {} (manual {})",
                                    label(context, decision.device, decision.parameter), time.asked_ms,
                                    milliseconds_text(time.effective_us), time.cycles,
                                    time.cycles == 1 ? "" : "s", parameter::to_text(decision.device),
                                    section_of(decision.device, decision.parameter)),
             .where = assignment->where});
    }
}

}  // namespace cgw::check
