#include "link/governor_end.hpp"

#include "device/gateway_errors.hpp"
#include "wire/little_endian.hpp"

namespace cgw::link {
namespace {

using device::GovernorCommand;

// Places in the outbox: a main cycle is complete after its data.
enum Place : std::size_t {
    command_place,
    analogue_place,
    errors_place = analogue_place + device::analogue_tpdos,
    cycle_place,
    configuration_place,
};
// Configuration telegrams in one main cycle: few enough to leave room for the data of a running plant.
constexpr std::size_t items_at_once = 4;

// It shows 12412.
bool knows_failure(const device::GatewayStatus& gateway) {
    const unsigned bit =
        device::row_of(device::Fault::initialisation).canopen_error - facts::first_canopen_error;
    return ((unsigned{gateway.canopen_errors} >> bit) & 1U) != 0;
}

}  // namespace

void GovernorEnd::open(const image::Image& image, std::uint8_t boot) {
    self_.node = image.governor().own_node;
    gateway_.node = image.governor().gateway_node;
    half_ = GovernorHalf(image);
    boot_ = boot;
    outbox_.clear();
    phase_ = Phase::searching;
    failed_attempts_ = 0;
    heard_ = false;
    gateway_was_reset_ = false;
    lost_ = false;
    next_attempt_ = 0;
    status_ = {};
    send_everything_ = true;
}

void GovernorEnd::main_cycle(const device::GovernorData& data, std::uint8_t flags, Time now) {
    if (heard_ && !lost_ && !online(now)) {
        lose_gateway();
    }
    const std::uint8_t lost = lost_ ? cycle::can_comm_error : std::uint8_t{0};
    send_data(data, static_cast<std::uint8_t>(flags | lost));
    step(now);
    outbox_.send(*port_);
}

// Nothing that it said before counts any more (D55).
void GovernorEnd::lose_gateway() {
    lost_ = true;
    status_ = {};
    if (phase_ != Phase::given_up) {
        phase_ = Phase::searching;
    }
    listener_->gateway_status(status_);
}

void GovernorEnd::step(Time now) {
    switch (phase_) {
        case Phase::searching:
            if (online(now) && now >= next_attempt_) {
                begin(now);
            }
            break;
        case Phase::configuring:
            send_items(now);
            break;
        case Phase::initialising:
        case Phase::concluding:
        case Phase::starting:
            if (now - phase_began_ > silence) {
                fail(now);
            }
            break;
        case Phase::given_up:
            if (online(now) && !knows_failure(status_) && now - phase_began_ > silence) {
                command(GovernorCommand::undefined, command::given_up, Phase::given_up, now);
            }
            break;
        case Phase::running:
            break;
    }
}

void GovernorEnd::begin(Time now) {
    next_item_ = 0;
    send_everything_ = true;  // the gateway begins with nothing
    const std::uint8_t flags = gateway_was_reset_ ? command::gateway_was_reset : std::uint8_t{0};
    command(GovernorCommand::init, flags, Phase::initialising, now);
}

void GovernorEnd::command(GovernorCommand command, std::uint8_t flags, Phase next, Time now) {
    frame::Frame frame = make_telegram(kind_of(Kind::command), self_, gateway_, command::length);
    frame.data[0] = ++sequence_;
    frame.data[1] = static_cast<std::uint8_t>(command);
    frame.data[2] = flags;
    frame.data[3] = boot_;
    outbox_.put(command_place, frame);
    phase_ = next;
    phase_began_ = now;
}

void GovernorEnd::send_items(Time now) {
    for (std::size_t i = 0; i < items_at_once; ++i) {
        if (outbox_.pending(configuration_place + i)) {
            return;  // the former ones first
        }
    }
    for (std::size_t i = 0; i < items_at_once && next_item_ < half_.count(); ++i) {
        outbox_.put(configuration_place + i, next_items());
    }
    if (next_item_ == half_.count()) {
        conclude(now);
    }
}

frame::Frame GovernorEnd::next_items() {
    frame::Frame frame = make_telegram(kind_of(Kind::configuration), self_, gateway_, configuration::length);
    wire::store_u16(frame.data.data(), next_item_);
    for (std::size_t i = 0; i < configuration::items && next_item_ < half_.count(); ++i, ++next_item_) {
        wire::store_u16(&frame.data[2 * (i + 1)], half_.item(next_item_).value);
    }
    return frame;
}

void GovernorEnd::conclude(Time now) {
    frame::Frame frame =
        make_telegram(kind_of(Kind::configuration_end), self_, gateway_, configuration::end_length);
    frame.data[0] = ++sequence_;
    wire::store_u16(&frame.data[1], half_.count());
    frame.data[3] = boot_;
    outbox_.put(configuration_place + items_at_once, frame);
    phase_ = Phase::concluding;
    phase_began_ = now;
}

void GovernorEnd::send_data(const device::GovernorData& data, std::uint8_t flags) {
    cycles_ = static_cast<std::uint8_t>((cycles_ + 1) & cycle::count_mask);
    if (outbox_.pending(cycle_place)) {
        return;  // CAN1 is slower than the governor; a newer set every time would never be complete
    }
    send_analogue(data);
    send_errors(data);
    frame::Frame last = make_telegram(kind_of(Kind::cycle), self_, gateway_, cycle::length);
    wire::store_u16(last.data.data(), data.errors[4]);
    wire::store_u16(&last.data[2], data.errors[5]);
    last.data[4] = static_cast<std::uint8_t>(data.engine_state);
    last.data[5] = static_cast<std::uint8_t>(flags | cycles_ << cycle::count_shift);
    last.data[6] = boot_;
    last.data[7] = clearings_;
    outbox_.put(cycle_place, last);
    sent_ = data;
    send_everything_ = false;
}

void GovernorEnd::send_analogue(const device::GovernorData& data) {
    for (std::size_t i = 0; i < data.analogue.size(); ++i) {
        if (!send_everything_ && data.analogue[i] == sent_.analogue[i]) {
            continue;
        }
        const auto tpdo = static_cast<unsigned>(i + device::first_analogue_tpdo);
        frame::Frame frame = make_telegram(kind_of(Kind::analogue, tpdo), self_, gateway_, 8);
        for (std::size_t word = 0; word < data.analogue[i].size(); ++word) {
            wire::store_u16(&frame.data[facts::word_bytes * word], data.analogue[i][word]);
        }
        outbox_.put(analogue_place + i, frame);
    }
}

void GovernorEnd::send_errors(const device::GovernorData& data) {
    frame::Frame frame = make_telegram(kind_of(Kind::errors_first), self_, gateway_, 8);
    bool changed = send_everything_;
    for (std::size_t word = 0; word < words_in_first_errors; ++word) {
        wire::store_u16(&frame.data[facts::word_bytes * word], data.errors[word]);
        changed = changed || data.errors[word] != sent_.errors[word];
    }
    if (changed) {
        outbox_.put(errors_place, frame);
    }
}

void GovernorEnd::fail(Time now) {
    ++failed_attempts_;
    if (failed_attempts_ >= attempts) {
        command(GovernorCommand::undefined, command::given_up, Phase::given_up, now);
    } else {
        begin(now);
    }
}

void GovernorEnd::clear_errors() {
    ++clearings_;
    allow_attempts();
}

void GovernorEnd::allow_attempts() {
    failed_attempts_ = 0;
    if (phase_ == Phase::given_up) {
        phase_ = Phase::searching;
    }
}

}  // namespace cgw::link
