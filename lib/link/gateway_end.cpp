#include "link/gateway_end.hpp"

#include "wire/little_endian.hpp"

namespace cgw::link {
namespace {

using device::Fault;
using device::GovernorCommand;

}  // namespace

void GatewayEnd::open(const image::Image& image, std::uint8_t boot) {
    self_.node = image.can1().own_node;
    governor_.node = image.can1().peer_node;
    half_ = GovernorHalf(image);
    boot_ = boot;
    outbox_.clear();
    status_ = {};
    data_ = {};
    next_status_ = 0;
    own_clearings_ = 0;
    spacing_ = image.governor().main_cycle_us;
    next_news_ = 0;
    status_news_ = false;
    error_news_ = false;
    process_data_news_ = 0;
    duplicate_until_ = canopen::never;
    heard_ = false;
    commanded_ = false;
    answer_ = Answer::none;
    configuration_fits_ = false;
    next_item_ = 0;
    mismatch_ = false;
    refusals_ = 0;
}

void GatewayEnd::receive(const frame::Frame& frame, Time now) {
    const std::optional<Telegram> telegram = read_telegram(frame);
    if (!telegram) {
        return;
    }
    if (telegram->from == self_) {
        notice_duplicate(now);
    }
    if (telegram->to != self_ || telegram->from != governor_) {
        return;
    }
    switch (telegram->kind) {
        case kind_of(Kind::command):
            obey(*telegram, now);
            break;
        case kind_of(Kind::configuration):
            compare(*telegram);
            break;
        case kind_of(Kind::configuration_end):
            conclude(*telegram);
            break;
        case kind_of(Kind::errors_first):
            take_errors(*telegram);
            break;
        case kind_of(Kind::cycle):
            complete_cycle(*telegram, now);
            break;
        default:
            take_analogue(*telegram);
            break;
    }
    outbox_.send(*port_);
}

// Sequences begin anew with each reset of the governor.
bool GatewayEnd::is_new(std::uint8_t sequence, std::uint8_t boot) {
    const bool again = commanded_ && sequence_ == sequence && command_boot_ == boot;
    commanded_ = true;
    sequence_ = sequence;
    command_boot_ = boot;
    return !again;
}

// A command is obeyed once; repeated, it is only acknowledged again.
void GatewayEnd::obey(const Telegram& telegram, Time now) {
    if (telegram.length < command::length ||
        telegram.data[1] > static_cast<std::uint8_t>(GovernorCommand::pre_operational)) {
        return;
    }
    if (is_new(telegram.data[0], telegram.data[3])) {
        obey(static_cast<GovernorCommand>(telegram.data[1]), telegram.data[2], now);
    }
    tell_status();
}

void GatewayEnd::obey(GovernorCommand command, std::uint8_t flags, Time now) {
    if ((flags & command::gateway_was_reset) != 0) {
        strike(Fault::gateway_reset, now);
    }
    if ((flags & command::given_up) != 0) {
        strike(Fault::initialisation, now);
    }
    if (command == GovernorCommand::init) {
        configuration_fits_ = false;
        mismatch_ = false;
        next_item_ = 0;
    } else if (command == GovernorCommand::pre_operational && !configuration_fits_) {
        answer_ = Answer::refused;
        return;
    }
    gateway_->command(command, now);
    // An error may forbid it.
    const device::GatewayState state = gateway_->state();
    const bool running = state != device::GatewayState::undefined && state != device::GatewayState::init;
    const bool obeyed = command == GovernorCommand::undefined ||
                        (command == GovernorCommand::init ? state == device::GatewayState::init : running);
    answer_ = obeyed ? Answer::accepted : Answer::refused;
}

void GatewayEnd::strike(Fault fault, Time now) {
    gateway_->report(fault, true, now);
    gateway_->report(fault, false, now);
}

// Somebody else has our number (3071), and may have it as long as it is heard.
void GatewayEnd::notice_duplicate(Time now) {
    duplicate_until_ = now + silence;
    gateway_->report(Fault::node_number_twice, true, now);
}

void GatewayEnd::forget_duplicate(Time now) {
    duplicate_until_ = canopen::never;
    gateway_->report(Fault::node_number_twice, false, now);
}

void GatewayEnd::clear_errors(Time now) {
    ++own_clearings_;
    status_news_ = true;
    gateway_->clear_errors(now);
}

void GatewayEnd::compare(const Telegram& telegram) {
    if (telegram.length < configuration::length || mismatch_) {
        return;
    }
    const std::uint16_t first = wire::load_u16(telegram.data);
    if (first != next_item_) {
        return;  // one is missing; the end will show it
    }
    for (std::size_t i = 0; i < configuration::items && next_item_ < half_.count(); ++i, ++next_item_) {
        const Item expected = half_.item(next_item_);
        const std::uint16_t received = wire::load_u16(telegram.data + 2 * (i + 1));
        if (received != expected.value) {
            mismatch_ = true;
            refuse({false, expected, received});
            return;
        }
    }
}

void GatewayEnd::refuse(const Refusal& refusal) {
    refusal_ = refusal;
    ++refusals_;
    tell_refusal();
}

void GatewayEnd::conclude(const Telegram& telegram) {
    if (telegram.length < configuration::end_length) {
        return;
    }
    if (is_new(telegram.data[0], telegram.data[3])) {
        const bool complete =
            next_item_ == half_.count() && wire::load_u16(telegram.data + 1) == half_.count();
        if (!complete && !mismatch_) {
            refuse({true, {}, 0});
        }
        configuration_fits_ = complete && !mismatch_;
        answer_ = configuration_fits_ ? Answer::accepted : Answer::refused;
    }
    tell_status();
}

void GatewayEnd::take_analogue(const Telegram& telegram) {
    const unsigned tpdo = telegram.kind - kind_of(Kind::analogue);
    if (tpdo < device::first_analogue_tpdo || tpdo > facts::tpdo_count ||
        telegram.length < facts::word_bytes * device::words_per_pdo) {
        return;
    }
    for (std::size_t word = 0; word < device::words_per_pdo; ++word) {
        data_.analogue[tpdo - device::first_analogue_tpdo][word] =
            wire::load_u16(telegram.data + facts::word_bytes * word);
    }
}

void GatewayEnd::take_errors(const Telegram& telegram) {
    if (telegram.length < facts::word_bytes * words_in_first_errors) {
        return;
    }
    for (std::size_t word = 0; word < words_in_first_errors; ++word) {
        data_.errors[word] = wire::load_u16(telegram.data + facts::word_bytes * word);
    }
}

void GatewayEnd::complete_cycle(const Telegram& telegram, Time now) {
    if (telegram.length < cycle::length) {
        return;
    }
    data_.errors[4] = wire::load_u16(telegram.data);
    data_.errors[5] = wire::load_u16(telegram.data + 2);
    data_.engine_state = telegram.data[4];
    const std::uint8_t flags = telegram.data[5];
    const std::uint8_t boot = telegram.data[6];
    const std::uint8_t clearings = telegram.data[7];
    const auto cycles = static_cast<std::uint8_t>(flags >> cycle::count_shift);
    const unsigned counted = unsigned(cycles - cycles_) & cycle::count_mask;
    const bool first = !heard_ || boot != governor_boot_ || counted == 0;
    if (heard_ && boot != governor_boot_) {
        strike(Fault::governor_reset, now);
    } else if (heard_ && clearings != clearings_) {
        gateway_->clear_errors(now);
    }
    heard_ = true;
    governor_boot_ = boot;
    clearings_ = clearings;
    cycles_ = cycles;
    gateway_->report(Fault::governor_can_bus, (flags & cycle::can_bus_error) != 0, now);
    gateway_->report(Fault::governor_can_comm, (flags & cycle::can_comm_error) != 0, now);
    gateway_->main_cycle(data_, now, first ? 1 : counted);
}

}  // namespace cgw::link
