#include "canopen/heartbeat.hpp"

#include "canopen/nmt.hpp"

namespace cgw::canopen {

void HeartbeatProducer::boot_up() {
    boot_up_pending_ = true;
    only_announced_ = false;
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
        only_announced_ = only_announced_ || !boot_up_pending_;
        boot_up_pending_ = true;
    } else if (!boot_up_pending_) {
        deadline_ = now;
    }
}

void HeartbeatProducer::withdraw_announcement() {
    if (only_announced_) {
        boot_up_pending_ = false;
        only_announced_ = false;
    }
}

bool HeartbeatProducer::send_due(NmtState state, Time now, frame::FramePort& port) {
    if (boot_up_pending_) {
        if (!port.send(heartbeat_frame(node_id_, NmtState::initialising))) {
            return false;
        }
        boot_up_pending_ = false;
        only_announced_ = false;
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
// After more than an hour without a single one a new rhythm begins: 32 bits are what a small controller
// divides.
void HeartbeatProducer::advance(Time now) {
    const Time late = now - deadline_;
    const auto short_late = static_cast<std::uint32_t>(late);
    const auto short_period = static_cast<std::uint32_t>(period_);
    deadline_ =
        now + (late == short_late && period_ == short_period ? period_ - short_late % short_period : period_);
}

}  // namespace cgw::canopen
