// Inside the emit room: the CAN database before it is printed, put together from these parts.
#pragma once

#include <string>
#include <vector>

#include "dbc/database.hpp"
#include "emit/emitter.hpp"
#include "signals/frames.hpp"

namespace cgw::emit {

// Who sends and who listens. The partner (428) stands for the CANopen master; without one there is a node
// "Master".
struct DbcNodes {
    std::string gateway;  // "GW12"
    std::string partner;  // "Node1"
};

DbcNodes dbc_nodes(const config::Configuration& configuration);

// "GW12_TPDO4": message names stay apart when the databases of several gateways are loaded together.
std::string dbc_message_name(const DbcNodes& nodes, const std::string& function);

// The active PDOs, in the order of the PDO table.
std::vector<dbc::Message> dbc_pdo_messages(const Plant& plant, const DbcNodes& nodes);

// NMT, SDO request and answer, heartbeats of the gateway and its partner.
std::vector<dbc::Message> dbc_service_messages(const Plant& plant, const DbcNodes& nodes);

// A signal of the plant in the words of the database.
dbc::Signal dbc_signal(const signals::Signal& from);

}  // namespace cgw::emit
