#include "canopen/node_guarding.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::canopen {
namespace {

constexpr std::uint8_t toggle_bit = 0x80;

bool is_error_control_of(const frame::Frame& frame, std::uint8_t node_id) {
    return frame.id == cob::heartbeat + node_id && !frame.extended;
}

Time life_end(Time now, Time life_time) {
    return life_time == 0 ? never : now + life_time;
}

}  // namespace

void GuardedNode::boot_up() {
    deadline_ = never;
    due_ = false;
    toggle_ = false;
    lost_ = false;
}

bool GuardedNode::receive(const frame::Frame& frame, Time now) {
    if (!is_error_control_of(frame, node_id_) || !frame.remote) {
        return false;
    }
    due_ = true;
    lost_ = false;
    deadline_ = life_end(now, life_time_);
    return true;
}

bool GuardedNode::send_due(NmtState state, frame::FramePort& port) {
    if (!due_) {
        return true;
    }
    frame::Frame answer = heartbeat_frame(node_id_, state);
    answer.data[0] = static_cast<std::uint8_t>(answer.data[0] | (toggle_ ? toggle_bit : 0));
    if (!port.send(answer)) {
        return false;
    }
    due_ = false;
    toggle_ = !toggle_;
    return true;
}

Time GuardedNode::poll(Time now) {
    if (now >= deadline_) {
        lost_ = true;
        deadline_ = never;
    }
    return deadline_;
}

void NodeGuard::start(Time now) {
    stop();
    if (guard_time_ != 0) {
        next_question_ = now;
        lost_at_ = life_end(now, life_time_);
    }
}

void NodeGuard::stop() {
    next_question_ = never;
    lost_at_ = never;
    expected_ = Toggle::either;
    refused_ = false;
    lost_ = false;
}

NodeGuard::Heard NodeGuard::receive(const frame::Frame& frame, Time now) {
    if (!is_error_control_of(frame, node_id_) || next_question_ == never) {
        return Heard::nothing;
    }
    frame::Frame answer = frame;
    answer.data[0] = static_cast<std::uint8_t>(frame.data[0] & ~toggle_bit);
    const std::optional<NmtState> state = heartbeat_state(answer);
    if (!state) {
        return Heard::nothing;
    }
    if (*state == NmtState::initialising) {
        expected_ = Toggle::clear;
        return Heard::boot_up;
    }
    const Toggle toggle = (frame.data[0] & toggle_bit) != 0 ? Toggle::set : Toggle::clear;
    if (expected_ != Toggle::either && toggle != expected_) {
        return Heard::wrong_toggle;
    }
    expected_ = toggle == Toggle::set ? Toggle::clear : Toggle::set;
    state_ = *state;
    lost_ = false;
    lost_at_ = life_end(now, life_time_);
    return Heard::state;
}

Time NodeGuard::poll(Time now, frame::FramePort& port) {
    if (now >= lost_at_) {
        lost_ = true;
        lost_at_ = never;
    }
    if (now >= next_question_) {
        frame::Frame question;
        question.id = cob::heartbeat + node_id_;
        question.length = 1;
        question.remote = true;
        refused_ = !port.send(question);
        if (refused_) {
            return lost_at_;
        }
        next_question_ += ((now - next_question_) / guard_time_ + 1) * guard_time_;
    }
    return std::min(next_question_, lost_at_);
}

}  // namespace cgw::canopen
