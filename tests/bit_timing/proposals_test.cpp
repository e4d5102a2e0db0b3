#include "bit_timing/proposals.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cgw::bit_timing {
namespace {

const Controller* const mcp2515 = find_controller("mcp2515");

Wish wish(std::uint32_t bit_rate, std::uint32_t clock_hz = 16'000'000) {
    return {.clock_hz = clock_hz, .controller = mcp2515, .bit_rate = bit_rate};
}

}  // namespace

// As public calculators have them: 500 k 00 B5 01, 250 k 01 B5 01, 125 k 03 B5 01, 1 M 00 91 01.
TEST(Proposals, are_those_of_public_calculators) {
    const std::pair<std::uint32_t, Registers> cases[] = {
        {500'000, {.prescaler = 0, .phase_segment_1 = 6, .phase_segment_2 = 1, .prop_segment = 5}},
        {250'000, {.prescaler = 1, .phase_segment_1 = 6, .phase_segment_2 = 1, .prop_segment = 5}},
        {125'000, {.prescaler = 3, .phase_segment_1 = 6, .phase_segment_2 = 1, .prop_segment = 5}},
        {1'000'000, {.prescaler = 0, .phase_segment_1 = 2, .phase_segment_2 = 1, .prop_segment = 1}},
    };
    for (const auto& [rate, registers] : cases) {
        const std::vector<Timing> found = propose(wish(rate));
        ASSERT_FALSE(found.empty()) << rate;
        EXPECT_EQ(found.front().registers, registers) << rate;
    }
}

TEST(Proposals, are_none_when_the_clock_cannot_make_the_rate) {
    EXPECT_TRUE(propose(wish(1'000'000, 8'000'000)).empty());
    EXPECT_TRUE(propose(wish(10'000, 1'000'000'000)).empty());
    EXPECT_TRUE(propose(wish(1, 1)).empty());
}

TEST(Proposals, work_and_come_near) {
    for (const Controller& controller : controllers) {
        for (std::uint32_t clock = 4'000'000; clock <= 40'000'000; clock += 4'608'000) {
            for (const StandardRate& rate : standard_rates()) {
                for (const double sample : {0.5, 0.875}) {
                    double last = 0;
                    for (const Timing& timing : propose({clock, &controller, rate.bit_rate, sample})) {
                        EXPECT_TRUE(violations(timing).empty());
                        const double error = std::abs(timing.bit_rate() / rate.bit_rate - 1);
                        EXPECT_LE(error, rate_tolerance);
                        EXPECT_GE(error, last - 1e-5);
                        last = error;
                    }
                }
            }
        }
    }
}

}  // namespace cgw::bit_timing
