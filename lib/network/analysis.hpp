// Loads and worst-case response times of the messages of one bus.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "network/message.hpp"
#include "network/response_time.hpp"

namespace cgw::network {

inline constexpr std::uint32_t lowest_bit_rate = 1'000;  // bit/s
inline constexpr std::uint32_t highest_bit_rate = 1'000'000;

struct Bus {
    std::uint32_t bit_rate = 0;    // bit/s, lowest_bit_rate..highest_bit_rate
    double errors_per_second = 0;  // frames that are destroyed; at most 10000
    std::uint64_t sdo_interval_us =
        assumed::sdo_us;  // between two SDO requests to one node; 0: none are sent
};

// Shares of the bus: 1 is all of it. Average: cyclic messages, with the stuff bits to be expected. Worst
// case: every message as often and as long as it may be.
struct BusLoad {
    double average = 0;
    double worst = 0;

    BusLoad& operator+=(const BusLoad& other) {
        average += other.average;
        worst += other.worst;
        return *this;
    }
};

struct MessageResult {
    Message message{};
    BusLoad load{};
    std::uint32_t worst_bits = 0;  // of one frame
    Bound bound = Bound::none;
    std::uint64_t response_us = 0;  // when a bound is found; rounded up

    bool bounded() const { return bound == Bound::found; }
    bool in_time() const {
        return bounded() && (message.deadline_us == 0 || response_us <= message.deadline_us);
    }
};

struct Analysis {
    Bus bus{};
    BusLoad load{};
    std::vector<MessageResult> messages{};  // in the order of the argument, without SDO if none is sent
};

// A bit time that is no whole number of nanoseconds counts as one longer.
Analysis analyse(std::span<const Message> messages, const Bus& bus);

}  // namespace cgw::network
