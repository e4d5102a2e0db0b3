#include "master/master.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::master {

using canopen::NmtState;
namespace cob = canopen::cob;

namespace {

bool is_heartbeat(const frame::Frame& frame) {
    return (frame.id & cob::function_mask) == cob::heartbeat && (frame.id & cob::node_mask) != 0 &&
           frame.length == 1;
}

bool is_state(std::uint8_t byte) {
    constexpr std::array known = {NmtState::initialising, NmtState::stopped, NmtState::operational,
                                  NmtState::pre_operational};
    return std::find(known.begin(), known.end(), static_cast<NmtState>(byte)) != known.end();
}

}  // namespace

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
    if (is_heartbeat(frame) && is_state(frame.data[0])) {
        const auto node_id = static_cast<std::uint8_t>(frame.id & cob::node_mask);
        const auto state = static_cast<NmtState>(frame.data[0]);
        if (state == NmtState::initialising) {
            listener_->boot_up(node_id, now);
        } else {
            listener_->heartbeat(node_id, state, now);
        }
    }
    const auto end = subscriptions_.begin() + static_cast<std::ptrdiff_t>(subscription_count_);
    if (std::find(subscriptions_.begin(), end, frame.id) != end) {
        listener_->process_data(frame, now);
    }
}

}  // namespace cgw::master
