#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "config/parts.hpp"
#include "config/reading.hpp"

namespace cgw::config {

namespace {

void resolve_nodes(const parameter::Settings& settings, Configuration& configuration) {
    const auto hzm_node = [](const parameter::ParameterSet& set, std::uint16_t number) {
        return setting<std::uint8_t>(set, number, facts::maximum_hzm_node);
    };
    configuration.governor_node = hzm_node(settings.governor, governor::own_node);
    configuration.gateway_node_in_governor = hzm_node(settings.governor, governor::gateway_node);
    configuration.gateway_node = hzm_node(settings.gateway, gateway::own_node);
    configuration.governor_node_in_gateway = hzm_node(settings.gateway, gateway::governor_node);
    configuration.node_id = setting<std::uint8_t>(settings.gateway, gateway::node_id, facts::maximum_node_id);
    configuration.partner_node_id =
        setting<std::uint8_t>(settings.gateway, gateway::partner_node_id, facts::maximum_node_id);
}

}  // namespace

std::uint16_t predefined_identifier(std::uint16_t base, std::uint8_t node_id) {
    return node_id == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(base + node_id);
}

Configuration resolve(const parameter::Settings& settings, const parameter::Catalogue& catalogue) {
    Configuration configuration;
    configuration.identity = settings.identity;
    if (settings.main_cycle_us != 0) {
        configuration.main_cycle_us = settings.main_cycle_us;
    }
    resolve_nodes(settings, configuration);
    resolve_buses(settings, configuration);
    resolve_transmit_pdos(settings, catalogue, configuration);
    resolve_receive_pdos(settings, configuration);
    resolve_heartbeats(settings, configuration);
    return configuration;
}

}  // namespace cgw::config
