// What the gateway tells its governor, and when.
#include <algorithm>

#include "link/gateway_end.hpp"
#include "wire/little_endian.hpp"

namespace cgw::link {
namespace {

// Places in the outbox, the most urgent first.
enum Place : std::size_t {
    status_place,
    refusal_place,
    first_errors_place,
    last_errors_place,
    process_data_place
};

}  // namespace

Time GatewayEnd::poll(Time now) {
    if (now >= duplicate_until_) {
        forget_duplicate(now);
    }
    if (now >= next_status_) {
        next_status_ = now + status_period;
        status_news_ = true;
        error_news_ = true;
    }
    const bool news = status_news_ || error_news_ || process_data_news_ != 0;
    if (news && now >= next_news_) {
        tell_news(now);
    }
    outbox_.send(*port_);
    const bool waiting = status_news_ || error_news_ || process_data_news_ != 0;
    return std::min({next_status_, duplicate_until_, waiting ? next_news_ : canopen::never});
}

void GatewayEnd::tell_news(Time now) {
    next_news_ = now + spacing_;
    if (status_news_) {
        tell_status();
    }
    if (error_news_) {
        tell_errors();
    }
    tell_process_data();
}

void GatewayEnd::follow(const device::GatewayStatus& status) {
    const bool errors = status.errors != status_.errors;
    const bool entered = status.operational_entries != status_.operational_entries;
    if (status.state != status_.state || entered) {  // what was received before counts no more
        process_data_news_ = 0;
        for (std::size_t rpdo = 0; rpdo < facts::rpdo_count; ++rpdo) {
            outbox_.withdraw(process_data_place + rpdo);
        }
    }
    status_ = status;
    status_news_ = true;
    error_news_ = error_news_ || errors;
}

void GatewayEnd::tell_status() {
    status_news_ = false;
    frame::Frame frame = make_telegram(kind_of(Kind::status), self_, governor_, status::length);
    frame.data[0] = static_cast<std::uint8_t>(status_.state);
    wire::store_u16(&frame.data[1], status_.canopen_errors);
    frame.data[3] = static_cast<std::uint8_t>(status_.late_rpdos | own_clearings_ << status::clearings_shift);
    frame.data[4] = static_cast<std::uint8_t>((status_.heartbeat_lost ? status::heartbeat_lost : 0) |
                                              status_.operational_entries << status::entries_shift);
    frame.data[5] = boot_;
    frame.data[6] = sequence_;
    frame.data[7] = static_cast<std::uint8_t>(commanded_ ? answer_ : Answer::none);
    outbox_.put(status_place, frame);
}

void GatewayEnd::tell_errors() {
    error_news_ = false;
    frame::Frame first = make_telegram(kind_of(Kind::own_errors_first), self_, governor_, 8);
    for (std::size_t word = 0; word < words_in_first_errors; ++word) {
        wire::store_u16(&first.data[facts::word_bytes * word], status_.errors[word]);
    }
    frame::Frame last = make_telegram(kind_of(Kind::own_errors_last), self_, governor_, 4);
    wire::store_u16(last.data.data(), status_.errors[4]);
    wire::store_u16(&last.data[2], status_.errors[5]);
    outbox_.put(first_errors_place, first);
    outbox_.put(last_errors_place, last);
}

void GatewayEnd::tell_refusal() {
    frame::Frame frame = make_telegram(kind_of(Kind::refusal), self_, governor_, refusal::length);
    frame.data[0] =
        refusal_.incomplete ? refusal::incomplete : static_cast<std::uint8_t>(refusal_.expected.kind);
    frame.data[1] = refusal_.expected.position;
    wire::store_u16(&frame.data[2], refusal_.received);
    wire::store_u16(&frame.data[4], refusal_.expected.value);
    outbox_.put(refusal_place, frame);
}

void GatewayEnd::forward(std::uint8_t rpdo, const device::PdoWords& words) {
    process_data_[rpdo - 1U] = words;
    process_data_news_ = static_cast<std::uint8_t>(process_data_news_ | 1U << (rpdo - 1U));
}

void GatewayEnd::tell_process_data() {
    for (unsigned rpdo = 1; rpdo <= facts::rpdo_count; ++rpdo) {
        if (((unsigned{process_data_news_} >> (rpdo - 1)) & 1U) == 0) {
            continue;
        }
        frame::Frame frame = make_telegram(kind_of(Kind::process_data, rpdo), self_, governor_, 8);
        for (std::size_t word = 0; word < device::words_per_pdo; ++word) {
            wire::store_u16(&frame.data[facts::word_bytes * word], process_data_[rpdo - 1][word]);
        }
        outbox_.put(process_data_place + rpdo - 1U, frame);
    }
    process_data_news_ = 0;
}

}  // namespace cgw::link
