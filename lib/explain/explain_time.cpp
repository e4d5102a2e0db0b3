// What the devices make of a time in ms: whole main cycles (D8), and for monitoring the consequence (D9).
#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"
#include "explain/entries.hpp"

namespace cgw::explain {

namespace {

using config::CyclicTime;
using parameter::Device;
using parameter::Row;

struct TimeParameter {
    Device device;
    std::uint16_t first;
    std::uint16_t last;
    std::uint32_t main_cycle_us;
    std::uint32_t most_cycles;
    bool monitors;
};

// The governor's main cycle is the one that holds without an own one in the parameter file.
constexpr std::uint32_t governor_cycle_us = facts::usual_governor_main_cycle_us;
constexpr TimeParameter time_parameters[] = {
    {Device::governor, config::governor::tpdo_cycle, config::governor::last_tpdo_cycle, governor_cycle_us,
     config::maximum_governor_cycles, false},
    {Device::governor, config::governor::rpdo_monitoring, config::governor::last_rpdo_monitoring,
     governor_cycle_us, config::maximum_governor_cycles, true},
    {Device::gateway, config::gateway::heartbeat_producer, config::gateway::heartbeat_producer,
     config::gateway_main_cycle_us, config::maximum_heartbeat_cycles, false},
    {Device::gateway, config::gateway::heartbeat_consumer, config::gateway::heartbeat_consumer,
     config::gateway_main_cycle_us, config::maximum_heartbeat_cycles, true},
};

std::vector<std::string> monitoring_lines(const CyclicTime& time, const TimeParameter& parameter) {
    std::vector<std::string> lines;
    if (config::trips_early(time)) {
        lines.push_back(fmt::format("a sender that keeps to {} ms is missed after {} already (D9)",
                                    time.asked_ms, base::milliseconds_text(time.effective_us)));
        const std::optional<CyclicTime> next =
            config::next_time_that_works(time, parameter.main_cycle_us, parameter.most_cycles);
        lines.push_back(next ? fmt::format("{} ms is the next time that works: {} main cycles, {}",
                                           next->asked_ms, next->cycles,
                                           base::milliseconds_text(next->effective_us))
                             : "no longer time is possible: let the sender send more often");
    }
    return lines;
}

}  // namespace

void add_time(Entry& entry, const Row& row, std::uint32_t value) {
    for (const TimeParameter& parameter : time_parameters) {
        const bool is_it = row.program == parameter::Program::application && row.device == parameter.device &&
                           row.number >= parameter.first && row.number <= parameter.last;
        if (!is_it || value == 0 || value > config::longest_time_ms) {
            continue;
        }
        const CyclicTime time = config::cyclic_time(value, parameter.main_cycle_us);
        if (time.cycles > parameter.most_cycles) {
            entry.add("effective",
                      fmt::format("none: the device counts at most {} main cycles of {}",
                                  parameter.most_cycles, base::milliseconds_text(parameter.main_cycle_us)));
            continue;
        }
        entry.add("effective",
                  fmt::format("{}: {} main cycle{} of {}{}", base::milliseconds_text(time.effective_us),
                              time.cycles, time.cycles == 1 ? "" : "s",
                              base::milliseconds_text(parameter.main_cycle_us),
                              row.device == Device::governor ? ", the default" : ""));
        if (parameter.monitors) {
            entry.add("monitoring", monitoring_lines(time, parameter));
        }
    }
}

}  // namespace cgw::explain
