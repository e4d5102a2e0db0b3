#include "canopen/heartbeat_consumer.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::canopen {

std::optional<std::size_t> HeartbeatConsumer::receive(const frame::Frame& frame, Time now) {
    for (std::size_t position = 0; position < nodes_.size(); ++position) {
        const Node& node = nodes_[position];
        if (node.node_id == 0 || frame.id != cob::heartbeat + node.node_id) {
            continue;
        }
        const std::optional<NmtState> state = heartbeat_state(frame);
        if (!state) {
            return std::nullopt;
        }
        hear(position, *state, now);
        return position;
    }
    return std::nullopt;
}

void HeartbeatConsumer::hear(std::size_t position, NmtState state, Time now) {
    Node& node = nodes_[position];
    node.state = state;
    node.heard = state != NmtState::initialising;
    node.lost = false;
    node.deadline = node.heard && node.period != 0 ? now + node.period + 1 : never;
}

std::optional<std::size_t> HeartbeatConsumer::expire(Time now) {
    for (std::size_t position = 0; position < nodes_.size(); ++position) {
        Node& node = nodes_[position];
        if (now >= node.deadline) {
            node.lost = true;
            node.deadline = never;
            return position;
        }
    }
    return std::nullopt;
}

Time HeartbeatConsumer::deadline() const {
    Time next = never;
    for (const Node& node : nodes_) {
        next = std::min(next, node.deadline);
    }
    return next;
}

}  // namespace cgw::canopen
