#include "device/gateway.hpp"

#include <algorithm>

#include "wire/copy.hpp"

namespace cgw::device {
namespace {

GatewayState gateway_state(canopen::NmtState state) {
    switch (state) {
        case canopen::NmtState::operational:
            return GatewayState::operational;
        case canopen::NmtState::stopped:
            return GatewayState::stopped;
        case canopen::NmtState::pre_operational:
            return GatewayState::pre_operational;
        case canopen::NmtState::initialising:
            break;
    }
    return GatewayState::init;
}

}  // namespace

void Gateway::command(GovernorCommand command, canopen::Time now) {
    if (!open_) {
        return;
    }
    hear_governor(now);
    if (errors_.blocking()) {
        return;
    }
    switch (command) {
        case GovernorCommand::undefined:
            initialise(GatewayState::undefined);
            break;
        case GovernorCommand::init:
            initialise(GatewayState::init);
            break;
        case GovernorCommand::pre_operational:
            if (state() == GatewayState::init) {
                slave_.boot_up();
                publish(GatewayState::pre_operational);
                slave_.poll(now);
            }
            break;
    }
}

// The object dictionary is made anew by every initialisation (manual, chapter 3); the errors of both devices
// stay (manual 5.1.1, 9.5).
void Gateway::initialise(GatewayState state) {
    slave_.initialise();
    wire::copy(initial_values_.data(), initial_values_.size(), values_.data());
    publish(state);
}

// Tells the governor when anything it keeps a copy of has changed.
void Gateway::publish(GatewayState state) {
    GatewayStatus status;
    status.state = state;
    status.late_rpdos = late_rpdos();
    status.heartbeat_lost = slave_.heartbeat_monitor().tripped();
    status.operational_entries = operational_entries_;
    errors_.set(Fault::receive_pdo_late, status.late_rpdos != 0);
    errors_.set(Fault::heartbeat_lost, status.heartbeat_lost);
    status.canopen_errors = errors_.canopen_errors();
    status.errors = errors_.words();
    store_errors();
    if (status != status_) {
        status_ = status;
        governor_->status_changed(status_);
    }
}

void Gateway::report(Fault fault, bool present, canopen::Time now) {
    if (errors_.present(fault) == present) {
        return;
    }
    errors_.set(fault, present);
    if (fault == Fault::can2_bus) {
        next_announcement_ = present ? now : next_announcement_;
        slave_.drop_answers();
    }
    if (present) {
        react(row_of(fault).reaction, now);
    }
    publish(state());
}

std::uint8_t Gateway::late_rpdos() const {
    unsigned late = 0;
    for (std::size_t row = 0; row < receive_pdos; ++row) {
        late |= receive_monitors_[row].tripped() ? 1U << row : 0U;
    }
    return static_cast<std::uint8_t>(late);
}

void Gateway::forget_errors() {
    errors_.clear();
    if (!errors_.shown(Fault::can2_bus)) {
        next_announcement_ = canopen::never;
        slave_.withdraw_announcement();
    }
}

void Gateway::clear_errors(canopen::Time now) {
    forget_errors();
    publish(state());
    slave_.poll(now);
}

void Gateway::react(Reaction reaction, canopen::Time now) {
    switch (reaction) {
        case Reaction::none:
            break;
        case Reaction::undefined:
            initialise(GatewayState::undefined);
            break;
        case Reaction::interrupted:
            if (state() != GatewayState::init) {
                initialise(GatewayState::undefined);
            }
            break;
        case Reaction::pre_operational:
            force(GatewayState::pre_operational, now);
            break;
        case Reaction::stopped:
            force(GatewayState::stopped, now);
            break;
    }
}

// Only a state machine that runs can be forced.
void Gateway::force(GatewayState state, canopen::Time now) {
    if (this->state() == GatewayState::undefined || this->state() == GatewayState::init) {
        return;
    }
    slave_.force(
        state == GatewayState::stopped ? canopen::NmtState::stopped : canopen::NmtState::pre_operational,
        now);
    publish(state);
}

void Gateway::receive(const frame::Frame& frame, canopen::Time now) {
    const canopen::Slave::Event event = slave_.receive(frame, now);
    switch (event.kind) {
        case canopen::Slave::Event::Kind::none:
            break;
        case canopen::Slave::Event::Kind::state_changed:
            follow_slave(now);
            break;
        case canopen::Slave::Event::Kind::reset:
            initialise(GatewayState::init);
            break;
        case canopen::Slave::Event::Kind::pdo_received:
            forward(event.position);
            follow_monitors();
            break;
        case canopen::Slave::Event::Kind::heartbeat:
            follow_monitors();
            break;
        case canopen::Slave::Event::Kind::sdo_overflow:
            errors_.strike(Fault::sdo_overflow);
            react(row_of(Fault::sdo_overflow).reaction, now);
            break;
    }
}

void Gateway::follow_slave(canopen::Time now) {
    const GatewayState state = gateway_state(slave_.state());
    if (state != GatewayState::operational) {
        publish(state);
    } else if (errors_.present(Fault::can2_bus)) {
        slave_.force(canopen::NmtState::pre_operational, now);  // 3072: no way past Pre-Operational
        publish(GatewayState::pre_operational);
    } else {
        enter_operational(now);
    }
}

void Gateway::enter_operational(canopen::Time now) {
    forget_errors();  // manual 9.5
    ++operational_entries_;
    publish(GatewayState::operational);
    for (std::size_t position = 0; position < binary_pdos; ++position) {
        slave_.request(position);  // D53: each entry sends them once
    }
    for (Rhythm& rhythm : rhythms_) {
        rhythm.left = 0;  // D53: due in the first governor cycle after entry
    }
    slave_.poll(now);
}

void Gateway::main_cycle(const GovernorData& data, canopen::Time now, unsigned elapsed) {
    if (!open_) {
        return;
    }
    hear_governor(now);
    store(data);
    if (state() == GatewayState::undefined || state() == GatewayState::init) {
        return;
    }
    if (state() == GatewayState::operational) {
        request_transmit_pdos(elapsed);
    }
    poll(now);
}

canopen::Time Gateway::poll(canopen::Time now) {
    if (!open_) {
        return canopen::never;
    }
    watch_governor(now);
    const canopen::Time announcement = announce(now);
    const canopen::Time slave = slave_.poll(now);
    follow_monitors();
    return std::min(slave, std::min(governor_deadline_, announcement));
}

void Gateway::hear_governor(canopen::Time now) {
    governor_deadline_ = std::max(now, start_up_end_) + governor_silence;
    if (errors_.present(Fault::governor_silent)) {
        report(Fault::governor_silent, false, now);
    }
}

void Gateway::watch_governor(canopen::Time now) {
    if (now >= governor_deadline_) {
        governor_deadline_ = canopen::never;
        report(Fault::governor_silent, true, now);
    }
}

// Late RPDOs and a lost heartbeat show at once, and vanish by themselves.
void Gateway::follow_monitors() {
    if (late_rpdos() != status_.late_rpdos ||
        slave_.heartbeat_monitor().tripped() != status_.heartbeat_lost) {
        publish(state());
    }
}

// Signs of life while 3072 is set, also when its cause is gone (D58): who waits for a boot-up hears one.
canopen::Time Gateway::announce(canopen::Time now) {
    if (now >= next_announcement_) {
        next_announcement_ = now + announcement_period;
        if (state() == GatewayState::pre_operational || state() == GatewayState::stopped) {
            slave_.announce(now);
        }
    }
    return next_announcement_;
}

}  // namespace cgw::device
