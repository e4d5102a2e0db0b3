// The messages of the gateway: its active PDOs, and the services every CANopen node has.
#include <fmt/format.h>

#include "base/canopen_text.hpp"
#include "canopen/words.hpp"
#include "emit/dbc_parts.hpp"
#include "facts/identifiers.hpp"

namespace cgw::emit {
namespace {

namespace cob = facts::cob;

dbc::Signal field(const std::string& name, unsigned start_bit, unsigned length) {
    dbc::Signal signal;
    signal.name = name;
    signal.start_bit = start_bit;
    signal.length = length;
    signal.maximum = static_cast<double>((std::uint64_t{1} << length) - 1);
    return signal;
}

std::string time_text(const signals::Frame& frame) {
    if (!frame.transmit()) {
        return frame.monitoring_us == 0 ? "not monitored"
                                        : fmt::format("monitored: comes at least every {}",
                                                      base::milliseconds_text(frame.monitoring_us));
    }
    return frame.period_us == 0 ? "sent when a bit changes"
                                : fmt::format("sent every {}", base::milliseconds_text(frame.period_us));
}

// Of a message with all its signals: who sends it, and who reads every signal.
void address(dbc::Message& message, const std::string& sender, const std::string& receiver) {
    message.sender = sender;
    for (dbc::Signal& signal : message.signals) {
        signal.receivers = {receiver};
    }
}

dbc::Message pdo_message(const DbcNodes& nodes, const signals::Frame& frame) {
    dbc::Message message;
    message.identifier = frame.identifier;
    message.name = dbc_message_name(nodes, frame.name);
    message.length = frame.length;
    message.comment = fmt::format("{} ({}, {}), {}", frame.name, base::object_text(frame.communication),
                                  base::object_text(frame.mapping), time_text(frame));
    if (frame.transmit()) {
        message.send_type = frame.period_us == 0 ? dbc::SendType::spontaneous : dbc::SendType::cyclic;
        if (frame.period_us != 0) {
            message.cycle_ms = frame.period_us / 1000;
        }
    }
    for (const signals::Signal& signal : frame.signals) {
        message.signals.push_back(dbc_signal(signal));
    }
    address(message, frame.transmit() ? nodes.gateway : nodes.partner,
            frame.transmit() ? nodes.partner : nodes.gateway);
    return message;
}

dbc::Message nmt_message(const DbcNodes& nodes) {
    dbc::Message message;
    message.identifier = cob::nmt;
    message.name = "NMT";
    message.length = 2;
    message.comment = "network management command";
    message.send_type = dbc::SendType::spontaneous;
    message.signals = {field("Command", 0, 8), field("NodeID", 8, 8)};
    for (const canopen::NmtCommandWords& row : canopen::nmt_commands) {
        message.signals[0].values.push_back({static_cast<std::uint8_t>(row.command), std::string(row.text)});
    }
    message.signals[1].comment = "0: all nodes";
    address(message, nodes.partner, nodes.gateway);
    return message;
}

dbc::Message sdo_message(const DbcNodes& nodes, const config::Configuration& configuration, bool request) {
    dbc::Message message;
    message.identifier =
        static_cast<std::uint16_t>((request ? cob::sdo_request : cob::sdo_answer) + configuration.node_id);
    message.name = dbc_message_name(nodes, request ? "SDO_Request" : "SDO_Answer");
    message.comment = request ? "access to the object dictionary" : "answer to an access, or its refusal";
    message.send_type = dbc::SendType::spontaneous;
    message.signals = {field("CommandSpecifier", 0, 8), field("Index", 8, 16), field("SubIndex", 24, 8),
                       field("Data", 32, 32)};
    address(message, request ? nodes.partner : nodes.gateway, request ? nodes.gateway : nodes.partner);
    return message;
}

dbc::Message heartbeat_message(const std::string& sender, const std::string& receiver, std::uint8_t node_id) {
    dbc::Message message;
    message.identifier = static_cast<std::uint16_t>(cob::heartbeat + node_id);
    message.name = sender + "_Heartbeat";
    message.length = 1;
    message.signals = {field("State", 0, 7)};
    for (const canopen::NmtStateText& row : canopen::nmt_states) {
        message.signals[0].values.push_back({static_cast<std::uint8_t>(row.state), std::string(row.text)});
    }
    address(message, sender, receiver);
    return message;
}

dbc::Message own_heartbeat(const DbcNodes& nodes, const config::Configuration& configuration) {
    const config::CyclicTime& time = configuration.heartbeat_producer;
    dbc::Message message = heartbeat_message(nodes.gateway, nodes.partner, configuration.node_id);
    message.comment = "boot-up only, no heartbeat is set";
    message.send_type = dbc::SendType::spontaneous;
    if (time.cycles != 0) {
        message.comment =
            fmt::format("boot-up, and heartbeat every {}", base::milliseconds_text(time.effective_us));
        message.send_type = dbc::SendType::cyclic;
        message.cycle_ms = time.effective_ms();
    }
    return message;
}

dbc::Message partner_heartbeat(const DbcNodes& nodes, const config::Configuration& configuration) {
    const config::CyclicTime& time = configuration.heartbeat_consumer;
    dbc::Message message = heartbeat_message(nodes.partner, nodes.gateway, configuration.partner_node_id);
    message.comment = time.cycles == 0 ? "not monitored by the gateway"
                                       : fmt::format("monitored by the gateway: comes at least every {}",
                                                     base::milliseconds_text(time.effective_us));
    return message;
}

}  // namespace

DbcNodes dbc_nodes(const config::Configuration& configuration) {
    return {
        fmt::format("GW{}", configuration.node_id),
        configuration.partner_node_id == 0 ? "Master" : fmt::format("Node{}", configuration.partner_node_id)};
}

std::string dbc_message_name(const DbcNodes& nodes, const std::string& function) {
    return fmt::format("{}_{}", nodes.gateway, function);
}

std::vector<dbc::Message> dbc_pdo_messages(const Plant& plant, const DbcNodes& nodes) {
    std::vector<dbc::Message> messages;
    for (const signals::Frame& frame :
         signals::frames_of(plant.settings, plant.catalogue, plant.configuration)) {
        messages.push_back(pdo_message(nodes, frame));
    }
    return messages;
}

std::vector<dbc::Message> dbc_service_messages(const Plant& plant, const DbcNodes& nodes) {
    const config::Configuration& configuration = plant.configuration;
    std::vector<dbc::Message> messages{
        nmt_message(nodes),
        sdo_message(nodes, configuration, true),
        sdo_message(nodes, configuration, false),
        own_heartbeat(nodes, configuration),
    };
    if (configuration.partner_node_id != 0) {
        messages.push_back(partner_heartbeat(nodes, configuration));
    }
    return messages;
}

}  // namespace cgw::emit
