#include "master/node_table.hpp"

#include <algorithm>

namespace cgw::master {

NodeTable::NodeTable() {
    for (std::size_t position = 0; position < nodes_.size(); ++position) {
        nodes_[position].node_id = static_cast<std::uint8_t>(position + 1);
    }
}

void NodeTable::hear(std::uint8_t node_id, canopen::NmtState state, canopen::Time now) {
    consumer_.hear(node_id - 1U, state, now);
    booted_[node_id - 1U] = booted_[node_id - 1U] || state == canopen::NmtState::initialising;
    next_ = std::min(next_, of(node_id).deadline);
}

// The table is gone through when a node can have been lost, not at each poll.
std::optional<std::uint8_t> NodeTable::expire(canopen::Time now) {
    if (now < next_) {
        return std::nullopt;
    }
    const std::optional<std::size_t> position = consumer_.expire(now);
    if (!position) {
        next_ = consumer_.deadline();
        return std::nullopt;
    }
    return nodes_[*position].node_id;
}

}  // namespace cgw::master
