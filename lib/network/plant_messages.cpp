#include <fmt/format.h>

#include <algorithm>

#include "config/numbers.hpp"
#include "facts/identifiers.hpp"
#include "network/source_parts.hpp"
#include "network/sources.hpp"

namespace cgw::network {
namespace {

using config::Configuration;
using config::Direction;
using config::Pdo;
using parameter::Device;
using parameter::Settings;
namespace cob = facts::cob;
namespace governor = config::governor;
namespace gateway = config::gateway;

std::string node_text(unsigned node_id) {
    return fmt::format("node {}", node_id);
}

// Where the file says when a message is sent, else the table in which it would.
diagnostic::Location place_of(const Settings& settings, Device device, std::uint16_t number) {
    const parameter::Assignment* assignment = settings.of(device).find(number);
    return assignment != nullptr        ? assignment->where
           : device == Device::governor ? settings.governor_table
                                        : settings.gateway_table;
}

class Plant {
  public:
    Plant(const Settings& settings, const Configuration& configuration, int plant)
        : settings_(settings), configuration_(configuration), plant_(plant) {}

    std::vector<Message> messages() {
        for (const Pdo& pdo : configuration_.pdos) {
            if (pdo.active) {
                pdo.direction == Direction::transmit ? add_tpdo(pdo) : add_rpdo(pdo);
            }
        }
        add_own_services();
        add_others();
        for (const parameter::NetworkMessage& row : settings_.network_messages) {
            add_row(row);
        }
        for (Message& message : messages_) {
            message.plant = plant_;
        }
        return std::move(messages_);
    }

  private:
    std::string own() const { return node_text(configuration_.node_id); }

    void add_tpdo(const Pdo& pdo) {
        Message message{.identifier = pdo.cob_id,
                        .bytes = pdo.length(),
                        .kind = Kind::pdo,
                        .name = pdo.name(),
                        .sender = own(),
                        .period_us = pdo.time.effective_us,
                        .tpdo = pdo.number};
        message.where = pdo.cob_id_source == config::CobIdSource::parameter
                            ? place_of(settings_, Device::gateway, gateway::tpdo_identifier_of(pdo.number))
                            : place_of(settings_, Device::gateway, gateway::node_id);
        if (pdo.number < config::first_analogue_tpdo) {
            message.release = Release::event;
            message.period_us = configuration_.main_cycle_us;
        }
        message.deadline_us = message.period_us;
        messages_.push_back(std::move(message));
    }

    void add_rpdo(const Pdo& pdo) {
        Message message{.identifier = pdo.cob_id,
                        .bytes = pdo.length(),
                        .kind = Kind::pdo,
                        .name = fmt::format("{} of {}", pdo.name(), own()),
                        .period_us = assumed::pdo_us,
                        .deadline_us = pdo.time.effective_us,
                        .monitored_us = pdo.time.effective_us,
                        .assumed = true,
                        .receiver = true};
        if (pdo.time.effective_us != 0) {
            message.period_us = pdo.time.effective_us / assumed::messages_in_monitored_time;
        }
        message.where = place_of(settings_, Device::governor, governor::rpdo_monitoring_of(pdo.number));
        messages_.push_back(std::move(message));
    }

    void add_own_services() {
        const unsigned node_id = configuration_.node_id;
        const diagnostic::Location where = place_of(settings_, Device::gateway, gateway::node_id);
        add_sdo(messages_, node_id, where);
        const std::uint64_t heartbeat_us = configuration_.heartbeat_producer.effective_us;
        if (heartbeat_us != 0) {
            messages_.push_back({.identifier = cob::heartbeat + node_id,
                                 .bytes = 1,
                                 .kind = Kind::heartbeat,
                                 .name = "heartbeat",
                                 .sender = own(),
                                 .period_us = heartbeat_us,
                                 .deadline_us = heartbeat_us,
                                 .where = place_of(settings_, Device::gateway, gateway::heartbeat_producer)});
        }
    }

    void add_others() {
        const unsigned partner = configuration_.partner_node_id;
        const std::uint64_t monitored_us = configuration_.heartbeat_consumer.effective_us;
        if (partner != 0) {
            const diagnostic::Location where =
                place_of(settings_, Device::gateway, gateway::heartbeat_consumer);
            add_heartbeat(partner, monitored_us, where);
        }
        for (const parameter::NetworkNode& node : settings_.network_nodes) {
            if (node.node_id != partner) {
                add_heartbeat(node.node_id, 0, node.where);
            }
        }
    }

    void add_heartbeat(unsigned node_id, std::uint64_t monitored_us, const diagnostic::Location& where) {
        Message message{.identifier = cob::heartbeat + node_id,
                        .bytes = 1,
                        .kind = Kind::heartbeat,
                        .name = "heartbeat",
                        .sender = node_text(node_id),
                        .period_us = assumed::heartbeat_us,
                        .deadline_us = monitored_us,
                        .monitored_us = monitored_us,
                        .assumed = true,
                        .where = where};
        if (monitored_us != 0) {
            message.period_us = monitored_us / assumed::messages_in_monitored_time;
        }
        messages_.push_back(std::move(message));
    }

    void add_row(const parameter::NetworkMessage& row) {
        messages_.push_back({.identifier = row.identifier,
                             .bytes = row.bytes,
                             .name = row.name,
                             .period_us = row.period_us,
                             .jitter_us = row.jitter_us,
                             .deadline_us = row.deadline_us,
                             .where = row.where});
    }

    const Settings& settings_;
    const Configuration& configuration_;
    int plant_;
    std::vector<Message> messages_;
};

}  // namespace

void add_sdo(std::vector<Message>& messages, unsigned node_id, const diagnostic::Location& where) {
    Message message{.identifier = cob::sdo_answer + node_id,
                    .bytes = 8,
                    .kind = Kind::sdo,
                    .release = Release::event,
                    .name = "SDO",
                    .sender = node_text(node_id),
                    .period_us = assumed::sdo_us,
                    .assumed = true,
                    .where = where};
    messages.push_back(message);
    message.identifier = cob::sdo_request + node_id;
    message.name = fmt::format("SDO to {}", node_text(node_id));
    message.sender.clear();
    messages.push_back(std::move(message));
}

std::vector<Message> messages_of(const Settings& settings, const Configuration& configuration, int plant) {
    return Plant(settings, configuration, plant).messages();
}

}  // namespace cgw::network
