#include "link/governor_end.hpp"

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
    next_attempt_ = 0;
    status_ = {};
    send_everything_ = true;
}

void GovernorEnd::main_cycle(const device::GovernorData& data, std::uint8_t flags, Time now) {
    if (!online(now) && phase_ != Phase::given_up) {
        phase_ = Phase::searching;
    }
    send_data(data, flags);
    step(now);
    outbox_.send(*port_);
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
        case Phase::running:
        case Phase::given_up:
            break;
    }
}

void GovernorEnd::begin(Time now) {
    next_item_ = 0;
    const std::uint8_t flags = gateway_was_reset_ ? command::gateway_was_reset : std::uint8_t{0};
    gateway_was_reset_ = false;
    command(GovernorCommand::init, flags, Phase::initialising, now);
}

void GovernorEnd::command(GovernorCommand command, std::uint8_t flags, Phase next, Time now) {
    frame::Frame frame = make_telegram(kind_of(Kind::command), self_, gateway_, command::length);
    frame.data[0] = ++sequence_;
    frame.data[1] = static_cast<std::uint8_t>(command);
    frame.data[2] = flags;
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
    outbox_.put(configuration_place + items_at_once, frame);
    phase_ = Phase::concluding;
    phase_began_ = now;
}

void GovernorEnd::send_data(const device::GovernorData& data, std::uint8_t flags) {
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
    frame::Frame errors = make_telegram(kind_of(Kind::errors_first), self_, gateway_, 8);
    bool changed = send_everything_;
    for (std::size_t word = 0; word < words_in_first_errors; ++word) {
        wire::store_u16(&errors.data[facts::word_bytes * word], data.errors[word]);
        changed = changed || data.errors[word] != sent_.errors[word];
    }
    if (changed) {
        outbox_.put(errors_place, errors);
    }
    frame::Frame last = make_telegram(kind_of(Kind::cycle), self_, gateway_, cycle::length);
    wire::store_u16(last.data.data(), data.errors[4]);
    wire::store_u16(&last.data[2], data.errors[5]);
    last.data[4] = static_cast<std::uint8_t>(data.engine_state);
    last.data[5] = flags;
    last.data[6] = boot_;
    last.data[7] = clearings_;
    outbox_.put(cycle_place, last);
    sent_ = data;
    send_everything_ = false;
}

void GovernorEnd::receive(const frame::Frame& frame, Time now) {
    const std::optional<Telegram> telegram = read_telegram(frame);
    if (!telegram || telegram->to != self_ || telegram->from != gateway_) {
        return;
    }
    if (telegram->kind == kind_of(Kind::status)) {
        hear_status(*telegram, now);
    } else if (telegram->kind == kind_of(Kind::refusal)) {
        hear_refusal(*telegram);
    } else if (telegram->kind == kind_of(Kind::own_errors_first) && telegram->length == 8) {
        for (std::size_t word = 0; word < words_in_first_errors; ++word) {
            status_.errors[word] = wire::load_u16(telegram->data + facts::word_bytes * word);
        }
        listener_->gateway_status(status_);
    } else if (telegram->kind == kind_of(Kind::own_errors_last) && telegram->length >= 4) {
        status_.errors[4] = wire::load_u16(telegram->data);
        status_.errors[5] = wire::load_u16(telegram->data + 2);
        listener_->gateway_status(status_);
    } else {
        hear_process_data(*telegram);
    }
}

void GovernorEnd::hear_status(const Telegram& telegram, Time now) {
    if (telegram.length < status::length ||
        telegram.data[0] > static_cast<std::uint8_t>(device::GatewayState::stopped)) {
        return;
    }
    const std::uint8_t boot = telegram.data[5];
    if (heard_ && boot != gateway_boot_) {
        gateway_was_reset_ = true;
        send_everything_ = true;
        if (phase_ != Phase::given_up) {
            phase_ = Phase::searching;
        }
    }
    heard_ = true;
    last_heard_ = now;
    gateway_boot_ = boot;
    status_.state = static_cast<device::GatewayState>(telegram.data[0]);
    status_.canopen_errors = wire::load_u16(telegram.data + 1);
    status_.late_rpdos = telegram.data[3];
    status_.heartbeat_lost = (telegram.data[4] & status::heartbeat_lost) != 0;
    listener_->gateway_status(status_);
    if (telegram.data[6] == sequence_ && telegram.data[7] <= static_cast<std::uint8_t>(Answer::refused)) {
        follow_answer(static_cast<Answer>(telegram.data[7]), now);
    }
    const bool fallen =
        status_.state == device::GatewayState::undefined || status_.state == device::GatewayState::init;
    if (phase_ == Phase::running && fallen) {
        phase_ = Phase::searching;  // an error, or a reset by the master
        failed_attempts_ = 0;
    }
}

void GovernorEnd::follow_answer(Answer answer, Time now) {
    if (answer == Answer::none) {
        return;
    }
    if (phase_ == Phase::initialising) {
        const bool accepted = answer == Answer::accepted;
        phase_ = accepted ? Phase::configuring : Phase::searching;
        next_attempt_ = accepted ? now : now + silence;  // an error of the gateway forbids it; it will tell
    } else if (phase_ == Phase::concluding || phase_ == Phase::starting) {
        if (answer == Answer::refused) {
            fail(now);
        } else if (phase_ == Phase::concluding) {
            command(GovernorCommand::pre_operational, 0, Phase::starting, now);
        } else {
            phase_ = Phase::running;
            failed_attempts_ = 0;
        }
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

void GovernorEnd::hear_refusal(const Telegram& telegram) {
    if (telegram.length >= refusal::length) {
        refusal_ = {telegram.data[0], telegram.data[1], wire::load_u16(telegram.data + 2),
                    wire::load_u16(telegram.data + 4)};
    }
}

void GovernorEnd::hear_process_data(const Telegram& telegram) {
    const unsigned rpdo = telegram.kind - kind_of(Kind::process_data);
    if (rpdo < 1 || rpdo > facts::rpdo_count || telegram.length < 8) {
        return;
    }
    device::PdoWords words{};
    for (std::size_t word = 0; word < words.size(); ++word) {
        words[word] = wire::load_u16(telegram.data + facts::word_bytes * word);
    }
    listener_->process_data(static_cast<std::uint8_t>(rpdo), words);
}

void GovernorEnd::clear_errors() {
    ++clearings_;
    failed_attempts_ = 0;
    if (phase_ == Phase::given_up) {
        phase_ = Phase::searching;
    }
}

}  // namespace cgw::link
