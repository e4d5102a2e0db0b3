#include "canopen/heartbeat.hpp"

#include "canopen/nmt.hpp"

namespace cgw::canopen {

void HeartbeatProducer::boot_up() {
    boot_up_pending_ = true;
    refused_ = false;
    deadline_ = never;
}

void HeartbeatProducer::silence() {
    boot_up_pending_ = false;
    refused_ = false;
    deadline_ = never;
}

void HeartbeatProducer::announce(Time now) {
    if (period_ == 0) {
        boot_up_pending_ = true;
    } else if (!boot_up_pending_) {
        deadline_ = now;
    }
}

bool HeartbeatProducer::send_due(NmtState state, Time now, frame::FramePort& port) {
    if (boot_up_pending_) {
        if (!port.send(heartbeat_frame(node_id_, NmtState::initialising))) {
            return false;
        }
        boot_up_pending_ = false;
        deadline_ = period_ == 0 ? never : now + period_;
        return true;
    }
    if (!due(now)) {
        return true;
    }
    refused_ = !port.send(heartbeat_frame(node_id_, state));
    if (refused_) {
        return false;
    }
    advance(now);
    return true;
}

// The rhythm is kept: a heartbeat sent late does not shift the following ones, missed ones are not made up.
void HeartbeatProducer::advance(Time now) {
    deadline_ += ((now - deadline_) / period_ + 1) * period_;
}

}  // namespace cgw::canopen
