#include "config/bit_rate.hpp"

#include <gtest/gtest.h>

namespace cgw::config {
namespace {

using parameter::ControllerFamily;

// Registers as typed, each the quantity less one.
BusTiming registers(std::uint8_t prescaler, std::uint8_t prop, std::uint8_t phase_1, std::uint8_t phase_2) {
    return {.manual = true,
            .prescaler = prescaler,
            .phase_segment_1 = phase_1,
            .phase_segment_2 = phase_2,
            .prop_segment = prop};
}

}  // namespace

// What other programs compute for an MCP2515 at 16 MHz: CNF1..3 are 00 B5 01, 01 B5 01, 03 B5 01, 00 91 01.
TEST(BitRate, of_the_mcp2515_counts_two_clocks_a_quantum) {
    const parameter::BitTiming at_16_mhz{.clock_hz = 16000000, .family = ControllerFamily::mcp2515};
    EXPECT_EQ(bit_rate(registers(0, 5, 6, 1), at_16_mhz), 500000U);
    EXPECT_EQ(bit_rate(registers(1, 5, 6, 1), at_16_mhz), 250000U);
    EXPECT_EQ(bit_rate(registers(3, 5, 6, 1), at_16_mhz), 125000U);
    EXPECT_EQ(bit_rate(registers(0, 1, 2, 1), at_16_mhz), 1000000U);
}

TEST(BitRate, of_the_at90can_counts_one) {
    const parameter::BitTiming at_16_mhz{.clock_hz = 16000000, .family = ControllerFamily::at90can};
    EXPECT_EQ(bit_rate(registers(3, 5, 6, 1), at_16_mhz), 250000U);
}

TEST(BitRate, is_rounded) {
    const parameter::BitTiming odd{.clock_hz = 7372800, .family = ControllerFamily::at90can};
    EXPECT_EQ(bit_rate(registers(1, 5, 5, 1), odd), 245760U);
    EXPECT_EQ(bit_rate(registers(63, 63, 63, 63), {.clock_hz = 1}), 0U);
}

}  // namespace cgw::config
