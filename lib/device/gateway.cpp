#include "device/gateway.hpp"

#include <algorithm>

#include "wire/little_endian.hpp"

namespace cgw::device {
namespace {

constexpr std::uint16_t engine_state_bits = 0x00FF;          // D22: the low byte
constexpr std::uint8_t error_register_generic = 0x01;        // D58: any error
constexpr std::uint8_t error_register_communication = 0x10;  // D58: 2005h is not 0

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
    switch (command) {
        case GovernorCommand::undefined:
            initialise(GatewayState::undefined);
            break;
        case GovernorCommand::init:
            initialise(GatewayState::init);
            break;
        case GovernorCommand::pre_operational:
            if (state_ == GatewayState::init) {
                slave_.boot_up();
                enter(GatewayState::pre_operational);
                slave_.poll(now);
            }
            break;
    }
}

// The object dictionary is made anew by every initialisation (manual, chapter 3).
void Gateway::initialise(GatewayState state) {
    slave_.initialise();
    std::copy(initial_values_.begin(), initial_values_.end(), values_.begin());
    enter(state);
}

void Gateway::enter(GatewayState state) {
    if (state != state_) {
        state_ = state;
        governor_->state_changed(state);
    }
}

void Gateway::receive(const frame::Frame& frame, canopen::Time now) {
    const canopen::Slave::Event event = slave_.receive(frame);
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
            break;
    }
}

void Gateway::follow_slave(canopen::Time now) {
    enter(gateway_state(slave_.state()));
    if (state_ != GatewayState::operational) {
        return;
    }
    for (std::size_t position = 0; position < binary_pdos; ++position) {
        slave_.request(position);  // D53: each entry sends them once
    }
    for (Rhythm& rhythm : rhythms_) {
        rhythm.left = 0;  // D53: due in the first governor cycle after entry
    }
    slave_.poll(now);
}

void Gateway::main_cycle(const GovernorData& data, canopen::Time now) {
    if (state_ == GatewayState::undefined || state_ == GatewayState::init) {
        return;
    }
    store(data);
    if (state_ == GatewayState::operational) {
        request_transmit_pdos();
    }
    slave_.poll(now);
}

void Gateway::request_transmit_pdos() {
    for (std::size_t position = 0; position < binary_pdos; ++position) {
        slave_.request_if_changed(position);
    }
    for (std::size_t position = binary_pdos; position < transmit_pdos; ++position) {
        Rhythm& rhythm = rhythms_[position];
        if (rhythm.cycles == 0) {
            continue;
        }
        if (rhythm.left == 0) {
            slave_.request(position);
            rhythm.left = rhythm.cycles;
        }
        --rhythm.left;
    }
}

void Gateway::store(const GovernorData& data) {
    bool any_error = false;
    for (std::size_t word = 0; word < error_words; ++word) {
        set(places_.errors[word], data.errors[word]);
        any_error = any_error || data.errors[word] != 0;
    }
    if (places_.has_engine_state) {
        set(places_.engine_state, data.engine_state & engine_state_bits);
    }
    for (std::size_t position = binary_pdos; position < transmit_pdos; ++position) {
        store_analogue(position, data.analogue[position - binary_pdos]);
    }
    const bool canopen_error = get(places_.canopen_errors) != 0;
    set(places_.error_register,
        static_cast<std::uint32_t>((any_error ? error_register_generic : 0) |
                                   (canopen_error ? error_register_communication : 0)));
}

void Gateway::store_analogue(std::size_t position, const PdoWords& words) {
    std::size_t word = 0;
    for (const canopen::MappedValue& place : rows_[position].mapping) {
        wire::store_u16(&values_[place.offset], words[word++]);
    }
}

void Gateway::set(const object::ObjectEntry& entry, std::uint32_t value) {
    object::store_value(values_, entry, value);
}

std::uint32_t Gateway::get(const object::ObjectEntry& entry) const {
    return object::load_value(values_, entry);
}

void Gateway::forward(std::size_t rpdo_row) {
    PdoWords words{};
    std::size_t word = 0;
    for (const canopen::MappedValue& place : rows_[transmit_pdos + rpdo_row].mapping) {
        words[word++] = place.dummy ? std::uint16_t{0} : wire::load_u16(&values_[place.offset]);
    }
    governor_->process_data(static_cast<std::uint8_t>(rpdo_row + 1), words);
}

}  // namespace cgw::device
