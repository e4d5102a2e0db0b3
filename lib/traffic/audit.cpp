#include "traffic/audit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canopen/protocol.hpp"
#include "facts/identifiers.hpp"

namespace cgw::traffic {
namespace {

namespace cob = facts::cob;

constexpr std::uint8_t state_mask = 0x7F;

std::uint8_t number(canopen::NmtState state) {
    return static_cast<std::uint8_t>(state);
}

Watched of_frame(const signals::Frame& frame) {
    return {.name = frame.name,
            .identifier = frame.identifier,
            .frame = &frame,
            .rhythm = Rhythm(frame.period_us, frame.monitoring_us)};
}

Watched of_heartbeat(std::uint8_t node, Microseconds period_us, Microseconds monitoring_us) {
    return {.name = fmt::format("heartbeat of node {}", node),
            .identifier = static_cast<std::uint16_t>(cob::heartbeat + node),
            .frame = nullptr,
            .rhythm = Rhythm(period_us, monitoring_us)};
}

}  // namespace

Audit::Audit(const Subject& subject, const Owners& owners) : subject_(subject), owners_(owners) {
    for (const signals::Frame& frame : subject.frames) {
        watched_.push_back(of_frame(frame));
    }
    if (subject.heartbeat_period_us != 0) {
        watched_.push_back(of_heartbeat(subject.node_id, subject.heartbeat_period_us, 0));
    }
    if (subject.heartbeat_monitoring_us != 0 && subject.partner != 0) {
        watched_.push_back(of_heartbeat(subject.partner, 0, subject.heartbeat_monitoring_us));
    }
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        watched_by_[watched_[i].identifier % watched_by_.size()] = static_cast<std::uint8_t>(i + 1);
    }
}

void Audit::take_fault(std::uint64_t number, const std::string& fault) {
    ++faults_;
    if (told_faults_.size() < most_told) {
        told_faults_.push_back({number, fault});
    }
}

// False where the clock went backwards: nothing is concluded from the time before.
bool Audit::keep_time(const Seen& seen, Place& place) {
    timed_ = timed_ && seen.has_time;
    place = {seen.number, timed_ ? seen.time_us : last_us_};
    if (!began_) {
        began_ = true;
        first_us_ = last_us_ = place.time_us;
    }
    const bool forwards = place.time_us >= last_us_;
    if (!forwards) {
        first_backwards_ = backwards_ == 0 ? place : first_backwards_;
        ++backwards_;
        state_since_.time_us = place.time_us;
        for (Watched& watched : watched_) {
            watched.rhythm.forget();
        }
    }
    last_us_ = place.time_us;
    return forwards;
}

void WrongLengths::add(std::uint8_t length, const Place& place) {
    if (count == 0) {
        first = place;
        bytes = length;
    }
    ++count;
}

void Audit::take(const Seen& seen) {
    Place place;
    keep_time(seen, place);
    ++frames_;
    const frame::Frame& frame = seen.frame;
    if (frame.extended) {
        first_extended_ = extended_ == 0 ? seen.number : first_extended_;
        ++extended_;
        return;
    }
    const Owner& owner = owners_.of(frame.id);
    ++by_service_[static_cast<std::size_t>(owner.service)];
    if (!owner.expected) {
        const std::size_t at = frame.id % unexpected_.size();
        unexpected_at_[at] = unexpected_[at] == 0 ? seen.number : unexpected_at_[at];
        ++unexpected_[at];
    }
    if (!frame.remote) {
        watch(owner, frame, place);
    }
}

void Audit::watch(const Owner& owner, const frame::Frame& frame, const Place& place) {
    switch (owner.service) {
        case Service::nmt:
            watch_command(frame, place);
            break;
        case Service::heartbeat:
            watch_heartbeat(owner, frame, place);
            break;
        case Service::pdo:
            watch_pdo(owner, frame, place);
            break;
        default:
            break;
    }
}

void Audit::watch_command(const frame::Frame& frame, const Place& place) {
    if (frame.length != 2 || (frame.data[1] != canopen::all_nodes && frame.data[1] != subject_.node_id)) {
        return;
    }
    switch (static_cast<canopen::NmtCommand>(frame.data[0])) {
        case canopen::NmtCommand::start:
            if (state_ != State::operational) {
                enter_operational(place, true);
            }
            break;
        case canopen::NmtCommand::reset_node:
        case canopen::NmtCommand::reset_communication:
        case canopen::NmtCommand::stop:
        case canopen::NmtCommand::enter_pre_operational:
            leave_operational(place, State::other);
            break;
    }
}

void Audit::watch_heartbeat(const Owner& owner, const frame::Frame& frame, const Place& place) {
    if (frame.length != 1) {
        return;
    }
    const auto state = static_cast<std::uint8_t>(frame.data[0] & state_mask);
    const bool boot_up = state == number(canopen::NmtState::initialising);
    if (const std::uint8_t at = watched_by_[frame.id % watched_by_.size()]; at != 0) {
        Rhythm& rhythm = watched_[at - 1U].rhythm;
        const bool own = owner.node == subject_.node_id;
        if (!boot_up || !own) {
            rhythm.take(place);
        }
        // A reset begins a new rhythm; the partner is monitored in Operational only (D54).
        if (own ? boot_up : state_ != State::operational) {
            rhythm.forget();
        }
    }
    if (owner.node != subject_.node_id) {
        return;
    }
    // A heartbeat that was on its way tells the state before the command.
    const bool settled =
        state_ == State::unknown || boot_up || place.time_us - state_since_.time_us > start_grace_us;
    if (!settled) {
        return;
    }
    if (state == number(canopen::NmtState::operational)) {
        if (state_ != State::operational) {
            enter_operational(place, state_ == State::other);
        }
    } else if (state_ != State::other) {
        leave_operational(place, State::other);
    }
}

void Audit::watch_pdo(const Owner& owner, const frame::Frame& frame, const Place& place) {
    Watched& watched = watched_[watched_by_[frame.id % watched_by_.size()] - 1U];
    watch_length(watched, frame, place);
    // A short RPDO does not feed its monitoring (D28, D55).
    if (!owner.frame->transmit() && frame.length < owner.frame->length) {
        watched.rhythm.take_dropped();
        return;
    }
    if (owner.frame->transmit() && state_ == State::unknown) {
        enter_operational(place, false);
        watched.rhythm.forget();
    }
    if (state_ == State::operational) {
        watched.rhythm.take(place);
        return;
    }
    const bool late = place.time_us - state_since_.time_us > start_grace_us;
    if (owner.frame->transmit() && state_ == State::other && late) {
        watched.first_when_stopped = watched.when_stopped == 0 ? place : watched.first_when_stopped;
        ++watched.when_stopped;
    }
    watched.rhythm.take(place);
    watched.rhythm.forget();
}

// Of a longer RPDO the first bytes count (D28); the gateway itself never sends more than is mapped.
void Audit::watch_length(Watched& watched, const frame::Frame& frame, const Place& place) {
    if (frame.length != watched.frame->length) {
        const bool tolerated = !watched.frame->transmit() && frame.length > watched.frame->length;
        (tolerated ? watched.longer : watched.wrong).add(frame.length, place);
    }
}

void Audit::enter_operational(const Place& place, bool recorded) {
    state_ = State::operational;
    state_since_ = place;
    was_operational_ = true;
    entry_recorded_ = entry_recorded_ || recorded;
    for (Watched& watched : watched_) {
        const bool gateways_own = watched.frame == nullptr && watched.rhythm.monitoring_us() == 0;
        if (!gateways_own && recorded) {
            watched.rhythm.arm(place);
        } else if (watched.frame != nullptr) {
            watched.rhythm.forget();
        }
    }
}

void Audit::note_window(const Place& place) {
    if (state_ == State::operational) {
        longest_window_us_ = std::max(longest_window_us_, place.time_us - state_since_.time_us);
    }
}

void Audit::leave_operational(const Place& place, State state) {
    note_window(place);
    for (Watched& watched : watched_) {
        if (state_ == State::operational &&
            (watched.frame != nullptr || watched.rhythm.monitoring_us() != 0)) {
            watched.rhythm.disarm(place);
        }
    }
    state_ = state;
    state_since_ = place;
}

void Audit::finish(bool has_lines) {
    has_lines_ = has_lines;
    const Place end{0, last_us_};
    note_window(end);
    for (Watched& watched : watched_) {
        const bool heartbeat_of_gateway = watched.frame == nullptr && watched.rhythm.monitoring_us() == 0;
        if (state_ == State::operational || heartbeat_of_gateway) {
            watched.rhythm.disarm(end);
        }
    }
}

}  // namespace cgw::traffic
