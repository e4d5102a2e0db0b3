// Who is watched, and how closely: RPDOs by the governor (manual 7.1.5), the partner by the gateway (7.2.3).
#include "check/monitoring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/monitoring_time.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

std::string help_for_early(const Watch& watch) {
    const std::optional<config::CyclicTime> next =
        config::next_time_that_works(watch.time, watch.main_cycle_us, watch.most_cycles);
    if (!next) {
        return fmt::format("no longer time is possible: let the sender send more often than every {}",
                           milliseconds_text(watch.time.effective_us));
    }
    return fmt::format(
        "{} ms is the next time that works: {} main cycles{}", next->asked_ms, next->cycles,
        next->effective_us == next->asked_ms * 1000 ? "" : ", " + milliseconds_text(next->effective_us));
}

// The first switch or sensor that the RPDO carries.
const Assignment* first_input(const Context& context, int rpdo) {
    const config::Configuration& configuration = context.configuration;
    if (rpdo == 1 && !configuration.switches.empty()) {
        return usable(context, Device::governor, configuration.switches.front().row->number);
    }
    for (const config::Sensor& sensor : configuration.sensors) {
        if (rpdo == 1 || facts::rpdo_of_channel(sensor.channel) == rpdo) {
            return usable(context, Device::governor, sensor.row->number);
        }
    }
    return nullptr;
}

// True when something else that is reported already keeps the RPDO inactive.
bool inputs_in_doubt(const Context& context) {
    for (const auto& [first, last] : {std::pair{governor::engine_stop, governor::last_switch},
                                      std::pair{governor::first_sensor, governor::last_sensor}}) {
        for (std::uint16_t number = first; number <= last; ++number) {
            if (context.settings.governor.rejected(number) ||
                context.settings.governor.rejected(governor::type_of(number))) {
                return true;
            }
        }
    }
    const diagnostic::Rule* const about_inputs[] = {
        &rules::switch_bit_range,       &rules::sensor_channel_range,  &rules::switch_without_bit,
        &rules::sensor_without_channel, &rules::sensor_channel_shared, &rules::engine_stop_over_canopen,
    };
    const auto& findings = context.findings.all();
    return std::any_of(findings.begin(), findings.end(), [&](const diagnostic::Diagnostic& finding) {
        return std::find(std::begin(about_inputs), std::end(about_inputs), finding.rule) !=
               std::end(about_inputs);
    });
}

}  // namespace

std::vector<Watch> watches(const Context& context) {
    const config::Configuration& configuration = context.configuration;
    std::vector<Watch> all;
    for (int number = 1; number <= config::rpdo_count; ++number) {
        const config::Pdo& pdo = configuration.rpdo(number);
        all.push_back({.device = Device::governor,
                       .number = governor::rpdo_monitoring_of(number),
                       .time = pdo.time,
                       .main_cycle_us = configuration.main_cycle_us,
                       .most_cycles = config::maximum_governor_cycles,
                       .watched = pdo.name(),
                       .active = pdo.active,
                       .section = "7.1.5"});
    }
    all.push_back({.device = Device::gateway,
                   .number = gateway::heartbeat_consumer,
                   .time = configuration.heartbeat_consumer,
                   .main_cycle_us = config::gateway_main_cycle_us,
                   .most_cycles = config::maximum_heartbeat_cycles,
                   .watched = fmt::format("the heartbeat of node {}", configuration.partner_node_id),
                   .active = configuration.partner_node_id != 0,
                   .section = "7.2.3"});
    return all;
}

void check_early_monitoring(const Context& context) {
    for (const Watch& watch : watches(context)) {
        const Assignment* assignment = sound(context, watch.device, watch.number);
        if (assignment == nullptr || !watch.active || watch.is_short() || !config::trips_early(watch.time)) {
            continue;
        }
        context.findings.report(
            {.rule = &rules::monitoring_early,
             .message =
                 fmt::format("{} is {} ms, but {} is missed after {} already: a sender that keeps to "
                             "{} ms trips it (manual {})",
                             label(context, watch.device, watch.number), watch.time.asked_ms, watch.watched,
                             milliseconds_text(watch.time.effective_us), watch.time.asked_ms, watch.section),
             .where = assignment->where,
             .help = help_for_early(watch)});
    }
}

void check_short_monitoring(const Context& context) {
    for (const Watch& watch : watches(context)) {
        const Assignment* assignment = sound(context, watch.device, watch.number);
        if (assignment == nullptr || !watch.active || !watch.is_short()) {
            continue;
        }
        context.findings.report(
            {.rule = &rules::monitoring_short,
             .message =
                 fmt::format("{} is {} ms, a single main cycle of {}: {} is missed as soon as it has to "
                             "wait for the bus (manual {})",
                             label(context, watch.device, watch.number), watch.time.asked_ms,
                             milliseconds_text(watch.time.effective_us), watch.watched, watch.section),
             .where = assignment->where,
             .help = fmt::format("the shortest time of two main cycles is {} ms; several times the sender's "
                                 "cycle is better",
                                 config::milliseconds_for(2, watch.main_cycle_us))});
    }
}

void check_unmonitored_rpdos(const Context& context) {
    for (const Watch& watch : watches(context)) {
        if (watch.device != Device::governor || !watch.active ||
            !is_off(context, watch.device, watch.number)) {
            continue;
        }
        const Assignment* typed = usable(context, watch.device, watch.number);
        const Assignment* input = first_input(context, governor::rpdo_of_monitoring(watch.number));
        const Assignment* place = typed != nullptr ? typed : input;
        context.findings.report(
            {.rule = &rules::rpdo_unmonitored,
             .message =
                 fmt::format("{} is not monitored, {} is {}: when its sender fails, the governor goes on "
                             "with the last values (manual 7.1.5)",
                             watch.watched, label(context, watch.device, watch.number),
                             off_text(context, watch.device, watch.number)),
             .where = place != nullptr ? place->where : table_of(context, watch.device),
             .help = fmt::format("write {} = a time of several cycles of the sender, in ms", watch.number)});
    }
}

void check_inactive_monitoring(const Context& context) {
    for (const Watch& watch : watches(context)) {
        const Assignment* assignment = sound(context, watch.device, watch.number);
        if (watch.device != Device::governor || watch.active || assignment == nullptr ||
            assignment->value == 0 || inputs_in_doubt(context)) {
            continue;
        }
        const int rpdo = governor::rpdo_of_monitoring(watch.number);
        context.findings.report(
            {.rule = &rules::rpdo_inactive_monitored,
             .message =
                 rpdo == 1
                     ? fmt::format("{} is {} ms, but RPDO1 is not active: no switch function and no "
                                   "sensor comes over CANopen (manual 7.1.5)",
                                   label(context, watch.device, watch.number), watch.time.asked_ms)
                     : fmt::format("{} is {} ms, but RPDO{} is not active: no sensor uses one of its "
                                   "channels {} to {} (manual 7.1.5)",
                                   label(context, watch.device, watch.number), watch.time.asked_ms, rpdo,
                                   facts::first_channel_of_rpdo(rpdo), facts::last_channel_of_rpdo(rpdo)),
             .where = assignment->where,
             .help = fmt::format("write {} = 0, or assign what the RPDO carries", watch.number)});
    }
}

}  // namespace cgw::check
