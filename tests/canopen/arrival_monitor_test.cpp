#include "canopen/arrival_monitor.hpp"

#include <gtest/gtest.h>

namespace cgw::canopen {
namespace {

TEST(ArrivalMonitor, watches_nothing_before_it_is_armed) {
    ArrivalMonitor monitor(1000);
    monitor.expire(1'000'000);
    EXPECT_FALSE(monitor.tripped());
    EXPECT_EQ(monitor.deadline(), never);
}

TEST(ArrivalMonitor, never_trips_without_a_period) {
    ArrivalMonitor monitor;
    monitor.arm(0);
    monitor.expire(1'000'000'000);
    EXPECT_FALSE(monitor.active());
    EXPECT_FALSE(monitor.tripped());
    EXPECT_EQ(monitor.deadline(), never);
}

TEST(ArrivalMonitor, gives_the_first_arrival_one_whole_period) {
    ArrivalMonitor monitor(1000);
    monitor.arm(500);
    EXPECT_EQ(monitor.deadline(), 1501U);
    monitor.expire(1500);
    EXPECT_FALSE(monitor.tripped());
    monitor.expire(1501);
    EXPECT_TRUE(monitor.tripped());
    EXPECT_EQ(monitor.deadline(), never);
}

TEST(ArrivalMonitor, takes_a_time_between_arrivals_that_is_exactly_the_period) {
    ArrivalMonitor monitor(1000);
    monitor.arm(0);
    for (Time now = 1000; now <= 10'000; now += 1000) {
        monitor.arrived(now);
        EXPECT_FALSE(monitor.tripped());
        EXPECT_EQ(monitor.deadline(), now + 1001);
    }
}

TEST(ArrivalMonitor, notices_a_late_arrival_nobody_waited_for) {
    ArrivalMonitor monitor(1000);
    monitor.arm(0);
    monitor.arrived(1001);
    EXPECT_TRUE(monitor.tripped());
}

TEST(ArrivalMonitor, recovers_with_two_arrivals_that_keep_the_period) {
    ArrivalMonitor monitor(1000);
    monitor.arm(0);
    monitor.expire(5000);
    monitor.arrived(6000);
    EXPECT_TRUE(monitor.tripped());
    monitor.arrived(7001);  // still too slow
    EXPECT_TRUE(monitor.tripped());
    monitor.arrived(8001);
    EXPECT_FALSE(monitor.tripped());
    EXPECT_EQ(monitor.deadline(), 9002U);
}

TEST(ArrivalMonitor, needs_two_arrivals_after_every_trip) {
    ArrivalMonitor monitor(1000);
    monitor.arm(0);
    monitor.expire(2000);
    monitor.arrived(2100);
    monitor.arrived(2200);
    monitor.expire(4000);
    monitor.arrived(4001);
    EXPECT_TRUE(monitor.tripped());
}

TEST(ArrivalMonitor, forgets_a_trip_when_it_is_disarmed_or_armed_anew) {
    ArrivalMonitor monitor(1000);
    monitor.arm(0);
    monitor.expire(2000);
    monitor.disarm();
    EXPECT_FALSE(monitor.tripped());
    monitor.arm(3000);
    monitor.expire(9000);
    monitor.arm(9000);
    EXPECT_FALSE(monitor.tripped());
    EXPECT_EQ(monitor.deadline(), 10'001U);
}

}  // namespace
}  // namespace cgw::canopen
