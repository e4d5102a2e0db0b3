// Node ids on the CANopen bus (manual 7.2.2, 7.2.3, 7.3; D14).
#include <fmt/format.h>

#include "check/subjects.hpp"
#include "check/support.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

using parameter::Assignment;
using parameter::Device;
namespace gateway = config::gateway;
namespace rules = diagnostic::rules;

bool is_own_partner(const Assignment* own, const Assignment* partner) {
    return own != nullptr && partner != nullptr && own->value != 0 && own->value == partner->value;
}

}  // namespace

void check_partner(const Context& context) {
    const Assignment* own = usable(context, Device::gateway, gateway::node_id);
    const Assignment* partner = usable(context, Device::gateway, gateway::partner_node_id);
    if (!is_own_partner(own, partner)) {
        return;
    }
    context.findings.report(
        {.rule = &rules::node_id_duplicate,
         .message = fmt::format("{} and {} are both {}; the partner is another node (manual 7.3)",
                                label(context, Device::gateway, gateway::partner_node_id),
                                label(context, Device::gateway, gateway::node_id), partner->value),
         .where = partner->where,
         .related = {here(*own)}});
}

void check_listed_nodes(const Context& context) {
    const Assignment* own = usable(context, Device::gateway, gateway::node_id);
    const Assignment* partner = usable(context, Device::gateway, gateway::partner_node_id);
    if (own == nullptr || is_own_partner(own, partner)) {
        return;
    }
    for (const parameter::NetworkNode& node : context.settings.network_nodes) {
        if (own->value != node.node_id) {
            continue;
        }
        context.findings.report(
            {.rule = &rules::node_id_listed,
             .message =
                 fmt::format("{} is {}, but [network] lists node {} as another node (manual 7.2.2)",
                             label(context, Device::gateway, gateway::node_id), own->value, node.node_id),
             .where = own->where,
             .related = {{.where = node.where,
                          .message = fmt::format("node {} is listed here", node.node_id)}},
             .help = "give the gateway a free node id, or take it out of nodes if it is the gateway itself"});
        return;
    }
}

void check_heartbeat_partner(const Context& context) {
    const Assignment* monitoring = usable(context, Device::gateway, gateway::heartbeat_consumer);
    const Assignment* partner = usable(context, Device::gateway, gateway::partner_node_id);
    const bool no_partner = (partner != nullptr && partner->value == 0) ||
                            absent(context, Device::gateway, gateway::partner_node_id);
    if (monitoring == nullptr || monitoring->value == 0 || !no_partner) {
        return;
    }
    diagnostic::Diagnostic finding{
        .rule = &rules::heartbeat_partner_missing,
        .message =
            fmt::format("{} is {}, but {} names no node to monitor (manual 7.2.3)",
                        label(context, Device::gateway, gateway::heartbeat_consumer), quantity(*monitoring),
                        label(context, Device::gateway, gateway::partner_node_id)),
        .where = monitoring->where};
    if (partner != nullptr) {
        finding.related = {here(*partner)};
    }
    finding.help = fmt::format("write the partner's node id as {}, or {} = 0 to monitor nobody",
                               gateway::partner_node_id, gateway::heartbeat_consumer);
    context.findings.report(std::move(finding));
}

void check_partner_unmonitored(const Context& context) {
    const Assignment* partner = sound(context, Device::gateway, gateway::partner_node_id);
    if (partner == nullptr || partner->value == 0 ||
        !is_off(context, Device::gateway, gateway::heartbeat_consumer)) {
        return;
    }
    diagnostic::Diagnostic finding{
        .rule = &rules::partner_unmonitored,
        .message =
            fmt::format("{} is {}, but {} is {}: nobody notices when node {} fails (manual 7.2.3)",
                        label(context, Device::gateway, gateway::partner_node_id), partner->value,
                        label(context, Device::gateway, gateway::heartbeat_consumer),
                        off_text(context, Device::gateway, gateway::heartbeat_consumer), partner->value),
        .where = partner->where,
        .help = fmt::format("write {} = a time of several heartbeats of node {}, in ms",
                            gateway::heartbeat_consumer, partner->value)};
    if (const Assignment* time = usable(context, Device::gateway, gateway::heartbeat_consumer)) {
        finding.related = {here(*time)};
    }
    context.findings.report(std::move(finding));
}

void check_heartbeat(const Context& context) {
    if (!is_off(context, Device::gateway, gateway::heartbeat_producer)) {
        return;
    }
    context.findings.report(
        {.rule = &rules::heartbeat_off,
         .message = fmt::format("{} is {}: nobody on the CANopen bus notices when the gateway fails "
                                "(manual 7.2.3)",
                                label(context, Device::gateway, gateway::heartbeat_producer),
                                off_text(context, Device::gateway, gateway::heartbeat_producer)),
         .where = place_of(context, Device::gateway, gateway::heartbeat_producer),
         .help = fmt::format("write {} = 1008 in [gateway.parameters] for a heartbeat every second",
                             gateway::heartbeat_producer)});
}

}  // namespace cgw::check
