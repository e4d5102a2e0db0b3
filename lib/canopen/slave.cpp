#include "canopen/slave.hpp"

#include <algorithm>

#include "canopen/nmt.hpp"

namespace cgw::canopen {

void Slave::configure(const Tables& tables) {
    node_id_ = tables.node_id;
    heartbeat_ = HeartbeatProducer(tables.node_id, tables.heartbeat_period);
    sdo_ = SdoServer(tables.node_id, tables.objects, tables.values);
    transmitter_ = PdoTransmitter(tables.transmit, tables.transmit_states, tables.values);
    receiver_ = PdoReceiver(tables.receive, tables.values);
    receive_monitors_ = tables.receive_monitors;
    partner_node_ = tables.partner_node;
    heartbeat_monitor_ = ArrivalMonitor(tables.partner_node == 0 ? 0 : tables.partner_period);
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

void Slave::request(std::size_t transmit_row) {
    if (state_ == NmtState::operational) {
        transmitter_.request(transmit_row);
    }
}

void Slave::request_if_changed(std::size_t transmit_row) {
    if (state_ == NmtState::operational) {
        transmitter_.request_if_changed(transmit_row);
    }
}

Slave::Event Slave::receive(const frame::Frame& frame, Time now) {
    if (state_ == NmtState::initialising) {
        return {};
    }
    if (frame.id == cob::sdo_request + node_id_) {
        return receive_sdo(frame);
    }
    if (frame.id == cob::nmt) {
        const std::optional<NmtCommand> command = nmt_command(frame, node_id_);
        return command ? obey(*command, now) : Event{};
    }
    if (state_ != NmtState::operational) {
        return {};
    }
    if (frame.id == cob::heartbeat + partner_node_) {
        return receive_heartbeat(frame, now);
    }
    return receive_pdo(frame, now);
}

Slave::Event Slave::receive_sdo(const frame::Frame& frame) {
    if (state_ == NmtState::stopped) {
        return {};
    }
    const std::uint32_t overflows = sdo_.counters().overflows;
    sdo_.receive(frame);
    if (!heartbeat_.pending()) {  // nothing overtakes the boot-up message
        sdo_.send_pending(*port_);
    }
    return {sdo_.counters().overflows == overflows ? Event::Kind::none : Event::Kind::sdo_overflow, 0};
}

Slave::Event Slave::receive_pdo(const frame::Frame& frame, Time now) {
    const std::optional<std::size_t> row = receiver_.receive(frame);
    if (!row) {
        return {};
    }
    receive_monitors_[*row].arrived(now);
    return {Event::Kind::pdo_received, *row};
}

Slave::Event Slave::receive_heartbeat(const frame::Frame& frame, Time now) {
    if (!heartbeat_state(frame)) {
        return {};
    }
    heartbeat_monitor_.arrived(now);
    return {Event::Kind::heartbeat, 0};
}

Slave::Event Slave::obey(NmtCommand command, Time now) {
    const NmtState before = state_;
    switch (command) {
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
}

Time Slave::poll(Time now) {
    if (state_ == NmtState::initialising) {
        return never;
    }
    const Time monitors = expire_monitors(now);
    send_due(now);
    return std::min(monitors, heartbeat_.deadline());
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

bool Slave::pending() const {
    return heartbeat_.pending() || sdo_.pending() || transmitter_.pending();
}

// The boot-up message goes before everything else; what the port refuses once, it refuses the next time too.
void Slave::send_due(Time now) {
    if (heartbeat_.send_due(state_, now, *port_) && sdo_.send_pending(*port_)) {
        transmitter_.send_pending(*port_);
    }
}

}  // namespace cgw::canopen
