#include "runtime/clock.hpp"

#include <gtest/gtest.h>

namespace cgw::runtime {
namespace {

constexpr Time start = 5'000'000'000;

TEST(RunClock, counts_microseconds_from_the_start) {
    RunClock clock(start);
    EXPECT_EQ(clock.at(start), 0U);
    EXPECT_EQ(clock.at(start + 1'500), 1'500U);
    EXPECT_EQ(clock.steady_at(20'000), start + 20'000);
    EXPECT_EQ(clock.steady_at(media::never), media::never);
}

TEST(RunClock, never_goes_backwards) {
    RunClock clock(start);
    EXPECT_EQ(clock.at(start + 700), 700U);
    EXPECT_EQ(clock.at(start + 600), 700U);
    EXPECT_EQ(clock.at(start - 1), 700U);
    EXPECT_EQ(clock.at(start + 701), 701U);
}

TEST(RunClock, lives_through_short_pauses) {
    RunClock clock(start);
    EXPECT_EQ(clock.at(start + RunClock::longest_pause), RunClock::longest_pause);
    EXPECT_EQ(clock.left_out(), 0U);
}

TEST(RunClock, leaves_out_the_time_in_which_the_program_did_not_run) {
    RunClock clock(start);
    clock.at(start + 1'000'000);
    constexpr Time hours = 7'200'000'000;
    EXPECT_EQ(clock.at(start + 1'000'000 + hours), 1'000'000U);
    EXPECT_EQ(clock.left_out(), hours);
    EXPECT_EQ(clock.at(start + 1'000'050 + hours), 1'000'050U);
    EXPECT_EQ(clock.left_out(), 0U);
    EXPECT_EQ(clock.steady_at(1'000'060), start + 1'000'060 + hours);
}

}  // namespace
}  // namespace cgw::runtime
