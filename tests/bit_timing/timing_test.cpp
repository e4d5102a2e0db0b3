#include "bit_timing/timing.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace cgw::bit_timing {
namespace {

const Controller* const mcp2515 = find_controller("mcp2515");
const Controller* const at90can = find_controller("at90can");

Timing timing(Registers registers, const Controller* controller = mcp2515,
              std::uint32_t clock_hz = 16'000'000) {
    return {.clock_hz = clock_hz, .controller = controller, .registers = registers};
}

// 16 TQ, sampled at 87.5 %, jump width 1.
constexpr Registers usual{.phase_segment_1 = 6, .phase_segment_2 = 1, .prop_segment = 5};

Registers with(std::uint32_t Registers::*member, std::uint32_t value, Registers registers = usual) {
    registers.*member = value;
    return registers;
}

}  // namespace

TEST(Controllers, are_found_by_name) {
    EXPECT_EQ(mcp2515, &controllers[0]);
    EXPECT_EQ(at90can, &controllers[1]);
    EXPECT_EQ(find_controller("sja1000"), nullptr);
    EXPECT_EQ(find_controller(""), nullptr);
}

TEST(Timing, follows_from_registers) {
    const Timing bit = timing(with(&Registers::prescaler, 1));
    EXPECT_EQ(bit.quanta(), 16U);
    EXPECT_EQ(bit.clocks_per_quantum(), 4U);
    EXPECT_DOUBLE_EQ(bit.quantum_ns(), 250);
    EXPECT_DOUBLE_EQ(bit.bit_rate(), 250'000);
    EXPECT_DOUBLE_EQ(bit.sample_point(), 0.875);
}

TEST(Timing, is_twice_as_fast_in_an_at90can) {
    EXPECT_DOUBLE_EQ(timing(with(&Registers::prescaler, 1), at90can).bit_rate(), 500'000);
}

// 16 TQ, 87.5 %, jump width 1: 0.4854 % and 0.3125 %.
TEST(Timing, tells_how_far_oscillators_may_be_off) {
    const Timing bit = timing(usual);
    EXPECT_NEAR(bit.phase_tolerance() * 100, 0.4854, 0.00005);
    EXPECT_NEAR(bit.jump_tolerance() * 100, 0.3125, 0.00005);
    EXPECT_DOUBLE_EQ(bit.tolerance(), bit.jump_tolerance());
}

TEST(Timing, without_violations_is_possible) {
    EXPECT_TRUE(violations(timing(usual)).empty());
    EXPECT_TRUE(violations(timing(usual, at90can)).empty());
}

struct Forbidden {
    const Controller* controller;
    Registers registers;
    std::string_view text;
};

TEST(Timing, tells_what_the_controller_forbids) {
    const Forbidden cases[] = {
        {mcp2515, with(&Registers::phase_segment_2, 0), "phase segment 2 has 1 TQ, the controller needs 2"},
        {mcp2515, with(&Registers::sync_jump_width, 1),
         "phase segment 2 has 2 TQ, which must be more than the jump width of 2 TQ"},
        {at90can, with(&Registers::sync_jump_width, 2),
         "phase segment 2 has 2 TQ, which must be at least the jump width of 3 TQ"},
        {mcp2515,
         {.phase_segment_1 = 1, .phase_segment_2 = 6, .prop_segment = 1},
         "phase segment 2 has 7 TQ, which must be at most the 4 TQ of propagation and phase segment 1"},
        {at90can,
         {.phase_segment_1 = 1, .phase_segment_2 = 4, .prop_segment = 6},
         "phase segment 2 has 5 TQ, which must be at most the 2 TQ of phase segment 1"},
        {mcp2515,
         {.phase_segment_1 = 0, .phase_segment_2 = 1, .prop_segment = 2},
         "a bit has 7 TQ, it must have 8 to 25"},
        {at90can, with(&Registers::sampling_mode, 1),
         "three samples a bit need a prescaler register above 0"},
        {mcp2515, with(&Registers::prescaler, 64), "BRP is 64, its register ends at 63"},
        {mcp2515, with(&Registers::prop_segment, 4'000'000'000),
         "Prop is 4000000000, its register ends at 7"},
    };
    for (const Forbidden& forbidden : cases) {
        const std::vector<std::string> found = violations(timing(forbidden.registers, forbidden.controller));
        EXPECT_EQ(std::vector<std::string>{std::string(forbidden.text)}, found);
    }
}

TEST(StandardRates, are_those_of_cia_301) {
    EXPECT_EQ(near_standard_rate(500'000)->bit_rate, 500'000U);
    EXPECT_EQ(near_standard_rate(125'600)->bit_rate, 125'000U);
    EXPECT_EQ(near_standard_rate(100'000), nullptr);
    EXPECT_EQ(near_standard_rate(0), nullptr);
}

TEST(BusLength, is_cias_where_bits_are_sampled_late) {
    const std::pair<double, std::uint32_t> cases[] = {{1e6, 25},     {8e5, 50},   {5e5, 100},  {2.5e5, 250},
                                                      {1.25e5, 500}, {5e4, 1000}, {2e4, 2500}, {1e4, 5000}};
    for (const auto& [rate, metres] : cases) {
        EXPECT_EQ(bus_length(rate, 0.875).metres, metres) << rate;
        EXPECT_FALSE(bus_length(rate, 0.875).by_sample_point) << rate;
    }
}

TEST(BusLength, between_two_rates_is_that_of_the_faster_one) {
    EXPECT_EQ(bus_length(400'000, 0.875).metres, 100U);
    EXPECT_EQ(bus_length(5'000, 0.875).metres, 5000U);
}

TEST(BusLength, is_less_where_bits_are_sampled_early) {
    const BusLength length = bus_length(500'000, 0.5);  // 1000 ns, 400 of them for the nodes
    EXPECT_EQ(length.metres, 60U);
    EXPECT_TRUE(length.by_sample_point);
    EXPECT_EQ(bus_length(1'000'000, 0.3).metres, 0U);
    EXPECT_EQ(bus_length(2'000'000, 0.875).metres, 0U);
    EXPECT_EQ(bus_length(0, 0.875).metres, 0U);
}

}  // namespace cgw::bit_timing
