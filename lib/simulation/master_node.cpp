#include "simulation/master_node.hpp"

#include <algorithm>

namespace cgw::simulation {

MasterNode::MasterNode(Bus& bus, std::uint8_t server_node_id, Time sdo_timeout)
    : port_(&bus.attach(*this)), master_(*port_, *this, server_node_id, sdo_timeout) {}

Time MasterNode::poll(Time now) {
    Time next = master_.poll(now);
    for (auto& [id, produced] : produced_) {
        if (now >= produced.due && port_->send(produced.frame)) {
            produced.due = now + produced.period;
        }
        if (produced.due > now) {
            next = std::min(next, produced.due);
        }
    }
    return next;
}

void MasterNode::produce(const frame::Frame& frame, Time period) {
    produced_[frame.id] = {frame, period, 0};
}

void MasterNode::boot_up(std::uint8_t node_id, Time now) {
    boot_ups_.push_back({now, node_id, canopen::NmtState::initialising});
}

void MasterNode::heartbeat(std::uint8_t node_id, canopen::NmtState state, Time now) {
    if (heartbeats_.size() == static_cast<std::size_t>(most_heartbeats)) {
        heartbeats_.erase(heartbeats_.begin(), heartbeats_.begin() + most_heartbeats / 2);
    }
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
