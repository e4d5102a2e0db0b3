// What the governor hears from the gateway.
#include "link/governor_end.hpp"
#include "wire/little_endian.hpp"

namespace cgw::link {

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
    hear_boot(telegram.data[5], static_cast<std::uint8_t>(telegram.data[3] >> status::clearings_shift));
    heard_ = true;
    lost_ = false;
    last_heard_ = now;
    status_.state = static_cast<device::GatewayState>(telegram.data[0]);
    status_.canopen_errors = wire::load_u16(telegram.data + 1);
    status_.late_rpdos = telegram.data[3] & status::late_rpdos_mask;
    status_.heartbeat_lost = (telegram.data[4] & status::heartbeat_lost) != 0;
    status_.operational_entries = static_cast<std::uint8_t>(telegram.data[4] >> status::entries_shift);
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

void GovernorEnd::hear_boot(std::uint8_t boot, std::uint8_t clearings) {
    if (heard_ && boot != gateway_boot_) {
        gateway_was_reset_ = true;
        phase_ = Phase::searching;
        failed_attempts_ = 0;
    } else if (heard_ && clearings != gateway_clearings_) {
        allow_attempts();
        listener_->errors_cleared();
    }
    gateway_boot_ = boot;
    gateway_clearings_ = clearings;
}

void GovernorEnd::follow_answer(Answer answer, Time now) {
    if (answer == Answer::none) {
        return;
    }
    if (phase_ == Phase::initialising) {
        const bool accepted = answer == Answer::accepted;
        gateway_was_reset_ = false;  // it has heard so
        phase_ = accepted ? Phase::configuring : Phase::searching;
        next_attempt_ = accepted ? now : now + silence;  // an error of the gateway forbids it; it will tell
    } else if (phase_ == Phase::concluding || phase_ == Phase::starting) {
        if (answer == Answer::refused) {
            fail(now);
        } else if (phase_ == Phase::concluding) {
            command(device::GovernorCommand::pre_operational, 0, Phase::starting, now);
        } else {
            phase_ = Phase::running;
            failed_attempts_ = 0;
        }
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

}  // namespace cgw::link
