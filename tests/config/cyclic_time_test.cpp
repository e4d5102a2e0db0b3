#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "config/configuration.hpp"
#include "config/numbers.hpp"

namespace cgw::config {
namespace {

struct Row {
    std::uint32_t asked_ms;
    std::uint32_t cycles;
    std::uint32_t effective_us;
};

void expect_rows(std::initializer_list<Row> rows, std::uint32_t main_cycle_us) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.asked_ms);
        const CyclicTime time = cyclic_time(row.asked_ms, main_cycle_us);
        EXPECT_EQ(time.asked_ms, row.asked_ms);
        EXPECT_EQ(time.cycles, row.cycles);
        EXPECT_EQ(time.effective_us, row.effective_us);
    }
}

TEST(CyclicTime, is_floored_to_governor_main_cycles_but_never_below_one) {
    expect_rows({{0, 0, 0},
                 {1, 1, 15625},
                 {14, 1, 15625},
                 {15, 1, 15625},  // the gap of the printed formula (D8)
                 {16, 1, 15625},
                 {31, 1, 15625},
                 {32, 2, 31250},
                 {100, 6, 93750},
                 {200, 12, 187500},
                 {1000, 64, 1000000},
                 {3984, 254, 3968750},
                 {3985, 255, 3984375},
                 {3999, 255, 3984375},
                 {4000, 256, 4000000}},  // one too many: a finding, not a cap
                15625);
}

TEST(CyclicTime, is_floored_to_gateway_main_cycles) {
    expect_rows({{1, 1, 16000},
                 {15, 1, 16000},
                 {16, 1, 16000},
                 {31, 1, 16000},
                 {32, 2, 32000},
                 {100, 6, 96000},
                 {112, 7, 112000},
                 {1000, 62, 992000},
                 {65535, 4095, 65520000}},
                gateway_main_cycle_us);
}

TEST(CyclicTime, carries_whole_milliseconds_into_objects_floored) {
    EXPECT_EQ(cyclic_time(16, 15625).effective_ms(), 15U);
    EXPECT_EQ(cyclic_time(100, 15625).effective_ms(), 93U);
    EXPECT_EQ(cyclic_time(1000, 15625).effective_ms(), 1000U);
}

TEST(CyclicTime, survives_nonsense) {
    constexpr auto huge = std::numeric_limits<std::uint32_t>::max();
    EXPECT_EQ(cyclic_time(100, 0).effective_us, 0U);
    EXPECT_EQ(cyclic_time(huge, 1).effective_us, huge);
    EXPECT_EQ(cyclic_time(huge, 15625).effective_us, huge);
    EXPECT_EQ(cyclic_time(1, huge).cycles, 1U);
}

}  // namespace
}  // namespace cgw::config
