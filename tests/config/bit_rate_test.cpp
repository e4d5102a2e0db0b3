// D7: the bit rate is computed only where the parameter file tells clock and controller family.
#include <gtest/gtest.h>

#include "config/configuration.hpp"

namespace cgw::config {
namespace {

using parameter::BitTiming;

const bit_timing::Controller* const mcp2515 = bit_timing::find_controller("mcp2515");
const bit_timing::Controller* const at90can = bit_timing::find_controller("at90can");

BusTiming registers(std::uint8_t prescaler, std::uint8_t prop, std::uint8_t phase_1, std::uint8_t phase_2) {
    BusTiming timing;
    timing.manual = true;
    timing.bit_rate_kbit = 250;  // not used: set by hand
    timing.prescaler = prescaler;
    timing.prop_segment = prop;
    timing.phase_segment_1 = phase_1;
    timing.phase_segment_2 = phase_2;
    return timing;
}

}  // namespace

TEST(BitRate, is_the_parameter_unless_timing_is_manual) {
    BusTiming timing;
    timing.bit_rate_kbit = 250;
    EXPECT_EQ(bit_rate(timing, std::nullopt), 250'000U);
    EXPECT_EQ(bit_rate(timing, BitTiming{16'000'000, mcp2515, {}}), 250'000U);
}

TEST(BitRate, is_not_guessed) {
    EXPECT_EQ(bit_rate(registers(0, 5, 6, 1), std::nullopt), std::nullopt);
}

// CNF1..3 at 16 MHz as public calculators give them: 500 k 00 B5 01, 250 k 01 B5 01, 125 k 03 B5 01, 1 M 00
// 91 01.
TEST(BitRate, follows_the_registers_of_an_mcp2515) {
    const BitTiming controller{16'000'000, mcp2515, {}};
    EXPECT_EQ(bit_rate(registers(0, 5, 6, 1), controller), 500'000U);
    EXPECT_EQ(bit_rate(registers(1, 5, 6, 1), controller), 250'000U);
    EXPECT_EQ(bit_rate(registers(3, 5, 6, 1), controller), 125'000U);
    EXPECT_EQ(bit_rate(registers(0, 1, 2, 1), controller), 1'000'000U);
}

TEST(BitRate, is_twice_as_high_in_an_at90can) {
    EXPECT_EQ(bit_rate(registers(1, 5, 6, 1), BitTiming{16'000'000, at90can, {}}), 500'000U);
}

TEST(BitRate, is_rounded) {
    EXPECT_EQ(bit_rate(registers(1, 5, 5, 1), BitTiming{7'372'800, at90can, {}}), 245'760U);
    EXPECT_EQ(bit_rate(registers(63, 63, 63, 63), BitTiming{1, at90can, {}}), 0U);
}

}  // namespace cgw::config
