#include "simulation/master_node.hpp"

namespace cgw::simulation {

MasterNode::MasterNode(Bus& bus, std::uint8_t server_node_id, Time sdo_timeout)
    : master_(bus.attach(*this), *this, server_node_id, sdo_timeout) {}

void MasterNode::boot_up(std::uint8_t node_id, Time now) {
    boot_ups_.push_back({now, node_id, canopen::NmtState::initialising});
}

void MasterNode::heartbeat(std::uint8_t node_id, canopen::NmtState state, Time now) {
    heartbeats_.push_back({now, node_id, state});
}

void MasterNode::process_data(const frame::Frame& frame, Time now) {
    Received& entry = received_[frame.id];
    entry.last = frame;
    entry.time = now;
    ++entry.count;
}

std::optional<MasterNode::Received> MasterNode::received(std::uint16_t cob_id) const {
    const auto found = received_.find(cob_id);
    return found == received_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace cgw::simulation
