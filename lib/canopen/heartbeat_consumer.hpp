// Heartbeat consumer for several nodes, as CiA 301 wants it: a node is watched from its first heartbeat on,
// and a boot-up message ends that until the next one. The Gateway's own consumer differs (D54;
// ArrivalMonitor).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::canopen {

class HeartbeatConsumer {
  public:
    // One watched node, an entry of 1016h.
    struct Node {
        std::uint8_t node_id = 0;
        NmtState state = NmtState::initialising;
        bool heard = false;  // a heartbeat since the last boot-up
        bool lost = false;
        Time period = 0;  // microseconds; 0: its state is followed, it is never missed
        Time deadline = never;
    };

    HeartbeatConsumer() = default;
    // The nodes outlive the consumer.
    explicit HeartbeatConsumer(std::span<Node> nodes) : nodes_(nodes) {}

    // Position of the node whose heartbeat or boot-up message the frame is.
    std::optional<std::size_t> receive(const frame::Frame& frame, Time now);
    // The same, for those who have read the frame themselves.
    void hear(std::size_t position, NmtState state, Time now);

    // Time passes: position of a node that has just gone missing. Ask again until there is none.
    std::optional<std::size_t> expire(Time now);
    // When expire() will find the next one.
    Time deadline() const;

  private:
    std::span<Node> nodes_;
};

}  // namespace cgw::canopen
