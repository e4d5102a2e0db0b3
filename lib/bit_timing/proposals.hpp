// From a bit rate to registers.
#pragma once

#include <vector>

#include "bit_timing/timing.hpp"

namespace cgw::bit_timing {

struct Wish {
    std::uint32_t clock_hz = 0;  // 1..1000000000
    const Controller* controller = nullptr;
    std::uint32_t bit_rate = 0;                // bit/s, 1..1000000
    double sample_point = recommended_sample;  // 0..1
};

// All prescalers with which the controller comes within `rate_tolerance` of the rate, each with the segments
// whose sample point is nearest to the wish; the best first: smallest error of the rate, sample point
// nearest, most quanta. Phase segment 1 and propagation segment share what stands before the sample point;
// the jump width is half of phase segment 2. None of them has violations(). Empty: this clock cannot make the
// rate.
std::vector<Timing> propose(const Wish& wish);

}  // namespace cgw::bit_timing
