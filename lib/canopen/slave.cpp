#include "canopen/slave.hpp"

#include "canopen/nmt.hpp"

namespace cgw::canopen {

void Slave::configure(const Tables& tables) {
    node_id_ = tables.node_id;
    heartbeat_ = HeartbeatProducer(tables.node_id, tables.heartbeat_period);
    sdo_ = SdoServer(tables.node_id, tables.objects, tables.values);
    transmitter_ = PdoTransmitter(tables.transmit, tables.transmit_states, tables.values);
    receiver_ = PdoReceiver(tables.receive, tables.values);
    initialise();
}

void Slave::initialise() {
    enter(NmtState::initialising);
    heartbeat_.silence();
}

void Slave::boot_up() {
    enter(NmtState::pre_operational);
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

Slave::Event Slave::receive(const frame::Frame& frame) {
    if (state_ == NmtState::initialising) {
        return {};
    }
    if (frame.id == cob::sdo_request + node_id_) {
        if (state_ != NmtState::stopped) {
            sdo_.receive(frame);
            if (!heartbeat_.pending()) {  // nothing overtakes the boot-up message
                sdo_.send_pending(*port_);
            }
        }
        return {};
    }
    if (frame.id == cob::nmt) {
        const std::optional<NmtCommand> command = nmt_command(frame, node_id_);
        return command ? obey(*command) : Event{};
    }
    if (state_ == NmtState::operational) {
        if (const std::optional<std::size_t> row = receiver_.receive(frame)) {
            return {Event::Kind::pdo_received, *row};
        }
    }
    return {};
}

Slave::Event Slave::obey(NmtCommand command) {
    const NmtState before = state_;
    switch (command) {
        case NmtCommand::start:
            enter(NmtState::operational);
            break;
        case NmtCommand::stop:
            enter(NmtState::stopped);
            break;
        case NmtCommand::enter_pre_operational:
            enter(NmtState::pre_operational);
            break;
        case NmtCommand::reset_node:
        case NmtCommand::reset_communication:
            initialise();
            return {Event::Kind::reset, 0};
    }
    return {state_ == before ? Event::Kind::none : Event::Kind::state_changed, 0};
}

void Slave::enter(NmtState state) {
    state_ = state;
    if (state != NmtState::operational) {
        transmitter_.cancel();
    }
    if (state == NmtState::initialising || state == NmtState::stopped) {
        sdo_.clear();
    }
}

Time Slave::poll(Time now) {
    if (state_ != NmtState::initialising) {
        send_due(now);
    }
    return heartbeat_.deadline();
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
