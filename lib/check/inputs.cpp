// Switch functions and sensors that come over CANopen (manual 7.1.4). Only where the type is 3 are 8nn and
// 9nn CANopen's business (D27).
#include <fmt/format.h>

#include <array>
#include <utility>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace rules = diagnostic::rules;

const Assignment* canopen_type(const Context& context, std::uint16_t number) {
    const Assignment* type = usable(context, Device::governor, governor::type_of(number));
    return type != nullptr && type->value == governor::canopen_type ? type : nullptr;
}

// Switch functions or sensors: what their assignment may hold, and what is said when it is 0.
struct Inputs {
    const diagnostic::Rule* rule;
    std::uint16_t first;
    std::uint16_t last;
    double lowest;
    double highest;
    std::string_view demand;
    const diagnostic::Rule* rule_for_zero;
    std::string_view consequence_of_zero;
    std::string_view help_for_zero;
};

const Inputs switches{.rule = &rules::switch_bit_range,
                      .first = governor::first_switch,
                      .last = governor::last_switch,
                      .lowest = -static_cast<double>(config::switch_bits),
                      .highest = config::switch_bits,
                      .demand = "RPDO1 word 1 has the bits 1 to 16, negative for low-active (manual 7.1.4.1)",
                      .rule_for_zero = &rules::switch_without_bit,
                      .consequence_of_zero = "no bit of RPDO1 switches it (manual 7.1.4.1)",
                      .help_for_zero = "its bit of RPDO1 word 1, 1 to 16, negative when low-active"};
const Inputs sensors{.rule = &rules::sensor_channel_range,
                     .first = governor::first_sensor,
                     .last = governor::last_sensor,
                     .lowest = 0,
                     .highest = config::sensor_channels,
                     .demand = "the words of RPDO2 to RPDO4 are the channels 1 to 12 (manual 7.1.4.2)",
                     .rule_for_zero = &rules::sensor_without_channel,
                     .consequence_of_zero = "no word of an RPDO carries it (manual 7.1.4.2)",
                     .help_for_zero = "its channel, 1 to 12 for the words of RPDO2 to RPDO4"};

void check_range(const Context& context, const Inputs& range) {
    for (std::uint16_t number = range.first; number <= range.last; ++number) {
        const Assignment* assignment = usable(context, Device::governor, number);
        const Assignment* type = canopen_type(context, number);
        if (assignment == nullptr || type == nullptr ||
            (assignment->value >= range.lowest && assignment->value <= range.highest)) {
            continue;
        }
        context.findings.report(
            {.rule = range.rule,
             .message = fmt::format("{} is {}, but {}", parameter::label(*assignment->row), assignment->value,
                                    range.demand),
             .where = assignment->where,
             .related = {here(*type)}});
    }
}

void check_zeros(const Context& context, const Inputs& inputs) {
    for (std::uint16_t number = inputs.first; number <= inputs.last; ++number) {
        const Assignment* type = canopen_type(context, number);
        if (type == nullptr || !is_off(context, Device::governor, number)) {
            continue;
        }
        const Assignment* assignment = usable(context, Device::governor, number);
        diagnostic::Diagnostic finding{
            .rule = inputs.rule_for_zero,
            .message = fmt::format("{} is 3 (CANopen), but {} is {}: {}", parameter::label(*type->row),
                                   label(context, Device::governor, number),
                                   off_text(context, Device::governor, number), inputs.consequence_of_zero),
            .where = assignment != nullptr ? assignment->where : type->where,
            .help = fmt::format("write {} = {}", number, inputs.help_for_zero)};
        if (assignment != nullptr) {
            finding.related = {here(*type)};
        }
        context.findings.report(std::move(finding));
    }
}

// `place` is "bit 5 of RPDO1 word 1" or "channel 7".
void report_shared(const Context& context, const diagnostic::Rule& rule, const parameter::Row& row,
                   const parameter::Row& earlier, const std::string& place, std::string_view section) {
    const Assignment* assignment = sound(context, Device::governor, row.number);
    const Assignment* other = usable(context, Device::governor, earlier.number);
    if (assignment == nullptr || other == nullptr) {
        return;
    }
    context.findings.report(
        {.rule = &rule,
         .message = fmt::format("{} uses {}, as {} does already (manual {})", parameter::label(row), place,
                                parameter::label(earlier), section),
         .where = assignment->where,
         .related = {here(*other)}});
}

}  // namespace

void check_switch_bits(const Context& context) {
    check_range(context, switches);
}
void check_sensor_channels(const Context& context) {
    check_range(context, sensors);
}

void check_switches_without_bit(const Context& context) {
    check_zeros(context, switches);
}
void check_sensors_without_channel(const Context& context) {
    check_zeros(context, sensors);
}

void check_shared_bits(const Context& context) {
    std::array<const parameter::Row*, config::switch_bits + 1> users{};
    for (const config::SwitchFunction& function : context.configuration.switches) {
        const parameter::Row*& first = users[function.bit];
        if (first == nullptr) {
            first = function.row;
            continue;
        }
        report_shared(context, rules::switch_bit_shared, *function.row, *first,
                      fmt::format("bit {} of RPDO1 word 1", function.bit), "7.1.4.1");
    }
}

void check_shared_channels(const Context& context) {
    std::array<const parameter::Row*, config::sensor_channels + 1> users{};
    for (const config::Sensor& sensor : context.configuration.sensors) {
        const parameter::Row*& first = users[sensor.channel];
        if (first == nullptr) {
            first = sensor.row;
            continue;
        }
        report_shared(context, rules::sensor_channel_shared, *sensor.row, *first,
                      fmt::format("channel {}", sensor.channel), "7.1.4.2");
    }
}

void check_engine_stop(const Context& context) {
    const Assignment* type = canopen_type(context, governor::engine_stop);
    if (type == nullptr) {
        return;
    }
    diagnostic::Diagnostic finding{
        .rule = &rules::engine_stop_over_canopen,
        .message = fmt::format("{} is 3: engine stop must be wired and must not come over CANopen "
                               "(manual 7.1.4.1)",
                               parameter::label(*type->row)),
        .where = type->where};
    const Assignment* bit = usable(context, Device::governor, governor::engine_stop);
    if (bit != nullptr && bit->value != 0) {
        finding.related = {here(*bit)};
    }
    context.findings.report(std::move(finding));
}

}  // namespace cgw::check
