// Gaps and periods against what is set.
#include "traffic/rhythm.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cgw::traffic {
namespace {

Rhythm fed(Rhythm rhythm, const std::vector<Microseconds>& times) {
    std::uint64_t number = 0;
    for (const Microseconds time : times) {
        rhythm.take({++number, time});
    }
    return rhythm;
}

std::vector<Microseconds> every(Microseconds period, int count) {
    std::vector<Microseconds> times;
    for (int i = 0; i < count; ++i) {
        times.push_back(period * static_cast<Microseconds>(i));
    }
    return times;
}

constexpr Microseconds period = 100'000;

}  // namespace

TEST(Rhythm, measures_what_came) {
    const Rhythm rhythm = fed({}, {0, 10, 40, 60});
    EXPECT_EQ(rhythm.frames(), 4U);
    EXPECT_EQ(rhythm.gaps(), 3U);
    EXPECT_EQ(rhythm.shortest_us(), 10U);
    EXPECT_EQ(rhythm.longest_us(), 30U);
    EXPECT_EQ(rhythm.mean_us(), 20);
}

TEST(Rhythm, tolerates_five_per_cent_of_the_mean) {
    EXPECT_EQ(fed({period, 0}, every(105'000, 10)).deviation(), 0);
    EXPECT_NEAR(fed({period, 0}, every(106'000, 10)).deviation(), 0.06, 1e-9);
    EXPECT_NEAR(fed({period, 0}, every(50'000, 10)).deviation(), -0.5, 1e-9);
    EXPECT_EQ(fed({period, 0}, every(50'000, 5)).deviation(), 0);  // four gaps say nothing
}

TEST(Rhythm, tells_the_longest_of_the_late_ones) {
    const Rhythm rhythm =
        fed({period, 0}, {0, 100'000, 260'000, 360'000, 660'000, 760'000, 860'000, 960'000});
    EXPECT_EQ(rhythm.late().count, 2U);
    EXPECT_EQ(rhythm.late().longest_us, 300'000U);
    EXPECT_EQ(rhythm.late().behind.number, 5U);
    EXPECT_EQ(rhythm.deviation(), 0);  // the other gaps are right
    EXPECT_EQ(fed({period, 0}, {0, 150'000}).late().count, 0U);
}

TEST(Rhythm, takes_many_late_ones_for_another_period) {
    const Rhythm rhythm = fed({period, 0}, every(200'000, 20));
    EXPECT_EQ(rhythm.late().count, 0U);
    EXPECT_NEAR(rhythm.deviation(), 1, 1e-9);
}

TEST(Rhythm, watches_the_monitoring_time) {
    EXPECT_EQ(fed({0, period}, {0, 100'000, 200'000}).exceeded().count, 0U);
    EXPECT_EQ(fed({0, period}, {0, 100'001, 200'002}).exceeded().count, 2U);
}

TEST(Rhythm, gives_the_first_frame_a_grace) {
    Rhythm in_time(0, period);
    in_time.arm({1, 1'000'000});
    in_time.take({2, 1'200'000});
    EXPECT_EQ(in_time.exceeded().count, 0U);
    EXPECT_EQ(in_time.gaps(), 0U);
    Rhythm late(0, period);
    late.arm({1, 1'000'000});
    late.take({2, 1'200'001});
    EXPECT_EQ(late.exceeded().count, 1U);
}

TEST(Rhythm, judges_what_is_missing_at_the_end_and_nothing_behind_it) {
    Rhythm rhythm = fed({period, 0}, {0, 100'000});
    rhythm.disarm({9, 300'000});
    EXPECT_EQ(rhythm.late().count, 1U);
    EXPECT_EQ(rhythm.gaps(), 1U);
    rhythm.take({10, 10'000'000});
    EXPECT_EQ(rhythm.late().count, 1U);
}

}  // namespace cgw::traffic
