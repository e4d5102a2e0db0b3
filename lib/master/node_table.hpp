// What a master knows of each node of its network, from boot-up messages and heartbeats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "canopen/heartbeat_consumer.hpp"

namespace cgw::master {

// Node-IDs are 1..127.
class NodeTable {
  public:
    NodeTable();
    NodeTable(const NodeTable&) = delete;
    NodeTable& operator=(const NodeTable&) = delete;
    ~NodeTable() = default;

    // From its next heartbeat on, the node is lost when `period` microseconds pass without one; 0: never.
    void watch(std::uint8_t node_id, canopen::Time period) { of(node_id).period = period; }

    // A boot-up message is the state `initialising`.
    void hear(std::uint8_t node_id, canopen::NmtState state, canopen::Time now);

    // Time passes: a node that has just been lost. Ask again until there is none.
    std::optional<std::uint8_t> expire(canopen::Time now);
    // When expire() will find the next one.
    canopen::Time deadline() const { return next_; }

    bool booted(std::uint8_t node_id) const { return booted_[node_id - 1U]; }  // seen since the start
    bool heard(std::uint8_t node_id) const { return of(node_id).heard; }  // a heartbeat since its boot-up
    bool lost(std::uint8_t node_id) const { return of(node_id).lost; }
    canopen::NmtState state(std::uint8_t node_id) const { return of(node_id).state; }  // the last one heard

  private:
    canopen::HeartbeatConsumer::Node& of(std::uint8_t node_id) { return nodes_[node_id - 1U]; }
    const canopen::HeartbeatConsumer::Node& of(std::uint8_t node_id) const { return nodes_[node_id - 1U]; }

    std::array<canopen::HeartbeatConsumer::Node, canopen::maximum_node_id> nodes_{};
    std::array<bool, canopen::maximum_node_id> booted_{};
    canopen::HeartbeatConsumer consumer_{nodes_};
    canopen::Time next_ = canopen::never;
};

}  // namespace cgw::master
