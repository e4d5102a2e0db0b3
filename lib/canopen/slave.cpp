#include "canopen/slave.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::canopen {

void Slave::configure(const Tables& tables) {
    node_id_ = tables.node_id;
    heartbeat_ = HeartbeatProducer(tables.node_id, tables.heartbeat_period);
    sdo_.open(tables.node_id, {tables.objects, tables.values, tables.handler});
    transmitter_ = PdoTransmitter(tables.transmit, tables.transmit_states, tables.values);
    receiver_ = PdoReceiver(tables.receive, tables.values);
    receive_monitors_ = tables.receive_monitors;
    partner_node_ = tables.partner_node;
    heartbeat_monitor_ = ArrivalMonitor(tables.partner_node == 0 ? 0 : tables.partner_period);
    next_trip_ = 0;
    initialise();
}

void Slave::initialise() {
    enter(NmtState::initialising, 0);
    heartbeat_.silence();
}

void Slave::boot_up() {
    enter(NmtState::pre_operational, 0);
    heartbeat_.boot_up();
}

Slave::Event Slave::receive(const frame::Frame& frame, Time now) {
    if (state_ == NmtState::initialising) {
        return {};
    }
    if (frame.id == cob::sdo_request + node_id_) {
        return receive_sdo(frame);
    }
    if (frame.id == cob::nmt) {
        return obey(frame, now);
    }
    return state_ == NmtState::operational ? receive_in_operational(frame, now) : Event{};
}

Slave::Event Slave::receive_sdo(const frame::Frame& frame) {
    if (state_ == NmtState::stopped) {
        return {};
    }
    // Nothing overtakes the boot-up message.
    const bool taken = sdo_.receive(frame, heartbeat_.pending() ? nullptr : port_);
    return {taken ? Event::Kind::none : Event::Kind::sdo_overflow, 0};
}

Slave::Event Slave::receive_in_operational(const frame::Frame& frame, Time now) {
    if (frame.id == cob::heartbeat + partner_node_) {
        return receive_heartbeat(frame, now);
    }
    const std::optional<std::size_t> row = receiver_.receive(frame);
    if (!row) {
        return {};
    }
    receive_monitors_[*row].arrived(now);
    next_trip_ = 0;
    return {Event::Kind::pdo_received, *row};
}

Slave::Event Slave::receive_heartbeat(const frame::Frame& frame, Time now) {
    if (!heartbeat_state(frame)) {
        return {};
    }
    heartbeat_monitor_.arrived(now);
    next_trip_ = 0;
    return {Event::Kind::heartbeat, 0};
}

Slave::Event Slave::obey(const frame::Frame& frame, Time now) {
    const std::optional<NmtCommand> command = nmt_command(frame, node_id_);
    if (!command) {
        return {};
    }
    const NmtState before = state_;
    switch (*command) {
        case NmtCommand::start:
            enter(NmtState::operational, now);
            break;
        case NmtCommand::stop:
            enter(NmtState::stopped, now);
            break;
        case NmtCommand::enter_pre_operational:
            enter(NmtState::pre_operational, now);
            break;
        case NmtCommand::reset_node:
        case NmtCommand::reset_communication:
            initialise();
            return {Event::Kind::reset, 0};
    }
    return {state_ == before ? Event::Kind::none : Event::Kind::state_changed, 0};
}

void Slave::enter(NmtState state, Time now) {
    if (state != state_) {
        watch(state == NmtState::operational, now);
    }
    state_ = state;
    if (state != NmtState::operational) {
        transmitter_.cancel();
    }
    if (state == NmtState::initialising || state == NmtState::stopped) {
        sdo_.clear();
    }
}

// D54, D55: watched in Operational only, from the moment of entry.
void Slave::watch(bool operational, Time now) {
    for (ArrivalMonitor& monitor : receive_monitors_) {
        operational ? monitor.arm(now) : monitor.disarm();
    }
    operational ? heartbeat_monitor_.arm(now) : heartbeat_monitor_.disarm();
    next_trip_ = 0;
}

Time Slave::poll(Time now) {
    if (state_ == NmtState::initialising) {
        return never;
    }
    if (now >= next_trip_) {
        next_trip_ = expire_monitors(now);
    }
    send_due(now);
    return std::min(next_trip_, heartbeat_.deadline());
}

// Returns when the next of them will trip.
Time Slave::expire_monitors(Time now) {
    heartbeat_monitor_.expire(now);
    Time next = heartbeat_monitor_.deadline();
    for (ArrivalMonitor& monitor : receive_monitors_) {
        monitor.expire(now);
        next = std::min(next, monitor.deadline());
    }
    return next;
}

// The boot-up message goes before everything else; what the port refuses once, it refuses the next time too.
void Slave::send_due(Time now) {
    if (heartbeat_.due(now) && !heartbeat_.send_due(state_, now, *port_)) {
        return;
    }
    if (sdo_.pending() && !sdo_.send_pending(*port_)) {
        return;
    }
    if (transmitter_.pending()) {
        transmitter_.send_pending(*port_);
    }
}

}  // namespace cgw::canopen
