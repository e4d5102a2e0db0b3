#include "master/master.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::master {

namespace cob = canopen::cob;

bool Master::command(canopen::NmtCommand command, std::uint8_t node_id) {
    return port_->send(canopen::nmt_frame(command, node_id));
}

bool Master::send_process_data(std::uint16_t cob_id, std::span<const std::uint8_t> data) {
    frame::Frame frame;
    frame.id = cob_id;
    const std::size_t length = std::min(data.size(), frame.data.size());
    frame.length = static_cast<std::uint8_t>(length);
    std::copy_n(data.begin(), length, frame.data.begin());
    return port_->send(frame);
}

bool Master::subscribe(std::uint16_t cob_id) {
    if (subscription_count_ == maximum_subscriptions) {
        return false;
    }
    subscriptions_[subscription_count_++] = cob_id;
    return true;
}

void Master::receive(const frame::Frame& frame, canopen::Time now) {
    if (frame.extended || frame.remote) {
        return;
    }
    sdo_.receive(frame);
    receive_heartbeat(frame, now);
    if (const std::optional<canopen::ReceivedEmergency> emergency = canopen::read_emergency(frame)) {
        listener_->emergency(*emergency, now);
    }
    const auto end = subscriptions_.begin() + static_cast<std::ptrdiff_t>(subscription_count_);
    if (std::find(subscriptions_.begin(), end, frame.id) != end) {
        listener_->process_data(frame, now);
    }
}

void Master::receive_heartbeat(const frame::Frame& frame, canopen::Time now) {
    const auto node_id = static_cast<std::uint8_t>(frame.id & cob::node_mask);
    if ((frame.id & cob::function_mask) != cob::heartbeat || node_id == 0) {
        return;
    }
    const std::optional<canopen::NmtState> state = canopen::heartbeat_state(frame);
    if (!state) {
        return;
    }
    nodes_.hear(node_id, *state, now);
    if (*state == canopen::NmtState::initialising) {
        listener_->boot_up(node_id, now);
    } else {
        listener_->heartbeat(node_id, *state, now);
    }
}

canopen::Time Master::poll(canopen::Time now) {
    while (const std::optional<std::uint8_t> node_id = nodes_.expire(now)) {
        listener_->lost(*node_id, now);
    }
    const canopen::Time sync = sync_.poll(now, *port_);
    commands_.send_pending(*port_);
    return std::min({sdo_.poll(now, *port_), sync, nodes_.deadline()});
}

}  // namespace cgw::master
