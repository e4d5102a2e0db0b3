#include <fmt/format.h>

#include "emit/artefacts.hpp"
#include "emit/database.hpp"
#include "emit/dbc_parts.hpp"

namespace cgw::emit {
namespace {

std::string summary(const Plant& plant) {
    const std::string& title = plant.settings.title;
    return fmt::format("{}Gateway node {}, configuration {}. Active PDOs only",
                       title.empty() ? "" : title + ". ", plant.configuration.node_id,
                       plant.configuration_id_text);
}

std::string partner_text(const config::Configuration& configuration) {
    return configuration.partner_node_id == 0
               ? "stands for whoever sends NMT commands, SDO requests and receive PDOs"
               : fmt::format(
                     "node {}, partner of the gateway (428); taken for the sender of NMT commands, SDO "
                     "requests and receive PDOs",
                     configuration.partner_node_id);
}

}  // namespace

dbc::Database database_of(const Plant& plant) {
    const DbcNodes nodes = dbc_nodes(plant.configuration);
    dbc::Database database;
    database.version =
        fmt::format("cgw {}, configuration {}", plant.tool_version_text, plant.configuration_id_text);
    database.comment = summary(plant);
    database.nodes = {
        {nodes.gateway, fmt::format("HEINZMANN CANopen Gateway, node {}", plant.configuration.node_id)},
        {nodes.partner, partner_text(plant.configuration)}};
    database.messages = dbc_pdo_messages(plant, nodes);
    for (dbc::Message& message : dbc_service_messages(plant, nodes)) {
        database.messages.push_back(std::move(message));
    }
    return database;
}

base::Bytes emit_dbc(const Plant& plant, const Options& /*options*/) {
    return base::to_bytes(dbc::print(database_of(plant)));
}

}  // namespace cgw::emit
