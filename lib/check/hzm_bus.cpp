// Both devices on the HEINZMANN CAN bus, CAN1 (manual 7.1.1, 7.2.1).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using config::gateway::hzm_bit_rate;
using config::gateway::hzm_manual_timing;
using parameter::Assignment;
using parameter::Device;
namespace governor = config::governor;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

struct HzmNodes {
    const Assignment* governor;             // as the governor has it: 401
    const Assignment* gateway_in_governor;  // 403
    const Assignment* gateway;              // as the gateway has it: 401
    const Assignment* governor_in_gateway;  // 402
};

bool differ(const Assignment* one, const Assignment* other) {
    return one != nullptr && other != nullptr && one->value != other->value;
}

// `own` is the number a device has, `known` what the other one takes it for. The governor's is the place.
void report_mismatch(const Context& context, const Assignment& own, const Assignment& known) {
    const bool own_is_governor = own.row->device == Device::governor;
    const Assignment& place = own_is_governor ? own : known;
    const Assignment& other = own_is_governor ? known : own;
    context.findings.report(
        {.rule = &rules::hzm_node_mismatch,
         .message = fmt::format("{} is {}, but {} is {} (manual 7.1.1)",
                                owned_label(context, place.row->device, place.row->number), place.value,
                                owned_label(context, other.row->device, other.row->number), other.value),
         .where = place.where,
         .related = {here(other)},
         .help = fmt::format("if the {} is node {}, write {} = {} in [{}.parameters]",
                             parameter::to_text(own.row->device), own.value, known.row->number, own.value,
                             parameter::to_text(known.row->device))});
}

// Each number stands where the other belongs: one mistake, one finding.
bool exchanged(const HzmNodes& nodes) {
    return differ(nodes.governor, nodes.governor_in_gateway) &&
           differ(nodes.gateway, nodes.gateway_in_governor) &&
           nodes.governor->value == nodes.gateway->value &&
           nodes.gateway_in_governor->value == nodes.governor_in_gateway->value;
}

void report_exchanged(const Context& context, const HzmNodes& nodes) {
    context.findings.report(
        {.rule = &rules::hzm_node_mismatch,
         .message = fmt::format("{} is {} and its {} is {}, but the governor is node {} and knows the "
                                "gateway as node {} (manual 7.1.1)",
                                owned_label(context, Device::gateway, gateway::own_node),
                                nodes.gateway->value, label(context, Device::gateway, gateway::governor_node),
                                nodes.governor_in_gateway->value, nodes.governor->value,
                                nodes.gateway_in_governor->value),
         .where = nodes.gateway->where,
         .related = {here(*nodes.governor), here(*nodes.gateway_in_governor)},
         .help =
             fmt::format("exchange the two: {} = {} and {} = {} in [gateway.parameters]", gateway::own_node,
                         nodes.gateway_in_governor->value, gateway::governor_node, nodes.governor->value)});
}

bool is_manual(const Context& context, Device device, std::uint16_t manual) {
    const parameter::ParameterSet& set = context.settings.of(device);
    return set.value(manual) != 0 || set.rejected(manual);
}

// A rate is known from its parameter, or for the gateway from its registers with a stated clock (D7, D17).
struct KnownRate {
    double kbit = 0;
    const Assignment* place = nullptr;  // null: the rate is not known
    std::string source{};               // "the governor's 416 CanBaudrate"
};

KnownRate governor_rate(const Context& context) {
    const bool manual = is_manual(context, Device::governor, governor::manual_timing);
    const Assignment* rate = usable(context, Device::governor, governor::bit_rate);
    if (manual || rate == nullptr) {
        return {};
    }
    return {rate->value, rate, owned_label(context, Device::governor, governor::bit_rate)};
}

KnownRate gateway_rate(const Context& context) {
    if (!is_manual(context, Device::gateway, hzm_manual_timing)) {
        const Assignment* rate = usable(context, Device::gateway, hzm_bit_rate);
        return rate == nullptr
                   ? KnownRate{}
                   : KnownRate{rate->value, rate, owned_label(context, Device::gateway, hzm_bit_rate)};
    }
    const Assignment* manual = usable(context, Device::gateway, hzm_manual_timing);
    constexpr int registers = 6;
    for (int i = 0; i < registers; ++i) {
        if (context.settings.gateway.rejected(static_cast<std::uint16_t>(gateway::hzm_prescaler + i))) {
            return {};
        }
    }
    if (manual == nullptr || !context.settings.can1_bit_timing) {
        return {};
    }
    const auto rate = config::bit_rate(context.configuration.can1, context.settings.can1_bit_timing);
    return {rate.value_or(0) / 1000.0, manual, "the gateway's bit timing by hand"};
}

// A rate computed from a clock is rarely round; no CAN bus works with oscillators that are 1 % apart.
bool rates_differ(double one, double other) {
    constexpr double tolerance = 0.01;
    return std::abs(one - other) > tolerance * one;
}

void check_switched_on(const Context& context, Device device, std::uint16_t number,
                       std::string_view consequence) {
    const Assignment* assignment = usable(context, device, number);
    const bool is_off = assignment != nullptr && assignment->value == 0;
    if (!is_off && !absent(context, device, number)) {
        return;
    }
    context.findings.report(
        {.rule = &rules::communication_off,
         .message = fmt::format("{} is {}: {}", label(context, device, number), is_off ? "0" : "not set",
                                consequence),
         .where = is_off ? assignment->where : table_of(context, device),
         .help = fmt::format("write {} = 1 in [{}.parameters]", number, parameter::to_text(device))});
}

}  // namespace

void check_hzm_nodes(const Context& context) {
    const HzmNodes nodes{.governor = usable(context, Device::governor, governor::own_node),
                         .gateway_in_governor = usable(context, Device::governor, governor::gateway_node),
                         .gateway = usable(context, Device::gateway, gateway::own_node),
                         .governor_in_gateway = usable(context, Device::gateway, gateway::governor_node)};
    if (exchanged(nodes)) {
        report_exchanged(context, nodes);
        return;
    }
    if (differ(nodes.governor, nodes.governor_in_gateway)) {
        report_mismatch(context, *nodes.governor, *nodes.governor_in_gateway);
    }
    if (differ(nodes.gateway, nodes.gateway_in_governor)) {
        report_mismatch(context, *nodes.gateway, *nodes.gateway_in_governor);
    }
}

void check_hzm_bit_rates(const Context& context) {
    const KnownRate of_governor = governor_rate(context);
    const KnownRate of_gateway = gateway_rate(context);
    if (of_governor.place == nullptr || of_gateway.place == nullptr ||
        !rates_differ(of_governor.kbit, of_gateway.kbit)) {
        return;
    }
    context.findings.report(
        {.rule = &rules::hzm_bit_rate_mismatch,
         .message = fmt::format("{} is {} kbit/s, but {} is {} kbit/s; both share the HEINZMANN CAN bus "
                                "(manual 7.1.1)",
                                of_governor.source, of_governor.kbit, of_gateway.source, of_gateway.kbit),
         .where = of_governor.place->where,
         .related = {here(*of_gateway.place)}});
}

void check_start_up_delays(const Context& context) {
    constexpr std::uint16_t number = governor::start_up_delay;  // 400 in both devices
    static_assert(governor::start_up_delay == gateway::start_up_delay);
    const Assignment* of_governor = usable(context, Device::governor, number);
    const Assignment* of_gateway = usable(context, Device::gateway, number);
    const bool known = (of_governor != nullptr || absent(context, Device::governor, number)) &&
                       (of_gateway != nullptr || absent(context, Device::gateway, number));
    const double governor_delay = of_governor != nullptr ? of_governor->value : 0;
    const double gateway_delay = of_gateway != nullptr ? of_gateway->value : 0;
    const auto& findings = context.findings.all();
    const bool silent = std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
        return finding.rule == &rules::communication_off;  // then nobody misses anybody
    });
    if (!known || silent || governor_delay == gateway_delay) {
        return;
    }
    const Assignment* place = of_governor != nullptr ? of_governor : of_gateway;
    const auto text = [](const Assignment* assignment) {
        return assignment != nullptr ? quantity(*assignment) : std::string("not set");
    };
    diagnostic::Diagnostic finding{
        .rule = &rules::start_up_delay_mismatch,
        .message = fmt::format("{} is {}, but {} is {}: one device expects the other before it is up "
                               "(manual 7.1.1)",
                               owned_label(context, Device::governor, number), text(of_governor),
                               owned_label(context, Device::gateway, number), text(of_gateway)),
        .where = place->where,
        .help = fmt::format("write {} = {} in both tables", number, std::max(governor_delay, gateway_delay))};
    if (place != of_gateway && of_gateway != nullptr) {
        finding.related = {here(*of_gateway)};
    }
    context.findings.report(std::move(finding));
}

void check_comparable_bit_rates(const Context& context) {
    const Assignment* of_governor = usable(context, Device::governor, governor::manual_timing);
    const Assignment* of_gateway = usable(context, Device::gateway, hzm_manual_timing);
    const auto is_on = [](const Assignment* manual) { return manual != nullptr && manual->value == 1; };
    const bool gateway_open = is_on(of_gateway) && !context.settings.can1_bit_timing;
    const Assignment* place = is_on(of_governor) ? of_governor : gateway_open ? of_gateway : nullptr;
    if (place == nullptr) {
        return;
    }
    diagnostic::Diagnostic finding{
        .rule = &rules::hzm_bit_rate_unverified,
        .message = fmt::format("{} is 1, bit timing by hand: whether both devices have the same bit rate "
                               "cannot be verified (manual 7.1.1)",
                               owned_label(context, place->row->device, place->row->number)),
        .where = place->where};
    if (place != of_gateway && gateway_open) {
        finding.related = {here(*of_gateway)};
    }
    context.findings.report(std::move(finding));
}

void check_communication(const Context& context) {
    check_switched_on(context, Device::governor, governor::gateway_communication,
                      "the governor does not talk to the gateway (manual 7.1.1)");
    check_switched_on(context, Device::gateway, gateway::governor_communication,
                      "the gateway does not talk to the governor (manual 7.2.1)");
}

}  // namespace cgw::check
