// Worst-case response times on a CAN bus: from the moment when a message is to be sent until its last bit is
// through. Frames are sent by priority, and one that has begun is not interrupted. After R. I. Davis, A.
// Burns, R. J. Bril, J. J. Lukkien, "Controller Area Network (CAN) schedulability analysis: Refuted,
// revisited and revised", Real-Time Systems 35 (2007): all instances of the busy period are looked at, for
// the first one is not always the latest. Whole nanoseconds; nothing is rounded on the way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cgw::network {

// What one message asks of the bus.
struct Stream {
    std::uint32_t priority = 0;   // the identifier: the lowest goes first
    std::uint64_t cost_ns = 0;    // longest time of one frame, above 0
    std::uint64_t period_ns = 0;  // shortest time between two releases, above 0
    std::uint64_t jitter_ns = 0;  // latest release after it was due
};

struct Disturbance {
    std::uint64_t bit_ns = 0;             // one bit time
    std::uint64_t error_interval_ns = 0;  // at most one error of the bus in such a time; 0: there are none
};

// Bit times that an error takes until the bus is idle again: flags of two nodes, delimiter, 3 bits between.
inline constexpr std::uint64_t error_bits = 31;

enum class Bound : std::uint8_t {
    found,
    none,       // messages of higher or equal priority take all the bus: it may wait for ever
    not_found,  // the search was given up: it may be late without limit
};

struct Response {
    Bound bound = Bound::none;
    std::uint64_t time_ns = 0;  // when found
};

// What is longer is cut to these, so that no sum overflows; bit rates from 1 kbit/s on are far from them.
inline constexpr std::uint64_t longest_ns = std::uint64_t{1} << 52U;  // 52 days; no response time is longer
inline constexpr std::uint64_t longest_frame_ns = std::uint64_t{1} << 28U;
inline constexpr std::uint64_t longest_bit_ns = std::uint64_t{1} << 23U;

// Streams in any order; the result has the same. Streams of equal priority delay each other. Every frame that
// an error hits is sent again, the longest one that may. The work is bounded whatever the numbers are.
std::vector<Response> response_times(std::span<const Stream> streams, const Disturbance& disturbance);

}  // namespace cgw::network
