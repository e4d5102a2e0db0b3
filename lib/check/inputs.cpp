// Switch functions and sensors that come over CANopen (manual 7.1.4). Only where the type is 3 are 8nn and
// 9nn CANopen's business (D27).
#include <fmt/format.h>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace rules = diagnostic::rules;

const Assignment* canopen_type(const Context& context, std::uint16_t number) {
    const Assignment* type =
        usable(context, Device::governor, static_cast<std::uint16_t>(number + governor::type_offset));
    return type != nullptr && type->value == governor::canopen_type ? type : nullptr;
}

struct InputRange {
    const diagnostic::Rule* rule;
    std::uint16_t first;
    std::uint16_t last;
    double lowest;
    double highest;
    std::string_view demand;
};

const InputRange switch_range{
    &rules::switch_bit_range, governor::first_switch,
    governor::last_switch,    -static_cast<double>(config::switch_bits),
    config::switch_bits,      "RPDO1 word 1 has the bits 1 to 16, negative for low-active (manual 7.1.4.1)"};
const InputRange sensor_range{
    &rules::sensor_channel_range, governor::first_sensor,
    governor::last_sensor,        0,
    config::sensor_channels,      "the words of RPDO2 to RPDO4 are the channels 1 to 12 (manual 7.1.4.2)"};

void check_range(const Context& context, const InputRange& range) {
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

}  // namespace

void check_switch_bits(const Context& context) {
    check_range(context, switch_range);
}
void check_sensor_channels(const Context& context) {
    check_range(context, sensor_range);
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
