#include "network/response_time.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <random>

namespace cgw::network {
namespace {

constexpr std::uint64_t ms = 1'000'000;

std::vector<double> times_ms(const std::vector<Response>& responses) {
    std::vector<double> times;
    for (const Response& response : responses) {
        times.push_back(response.bound == Bound::found ? static_cast<double>(response.time_ns) / ms : -1);
    }
    return times;
}

}  // namespace

// The example with which Davis and others refute the older analysis: 125 bits at 125 kbit/s. The second
// instance of the third message is the later one; the first takes 3 ms.
TEST(ResponseTime, of_the_counterexample_of_davis) {
    const Stream streams[] = {{1, ms, 5 * ms / 2, 0}, {2, ms, 7 * ms / 2, 0}, {3, ms, 7 * ms / 2, 0}};
    EXPECT_EQ(times_ms(response_times(streams, {.bit_ns = 8'000})), (std::vector{2.0, 3.0, 3.5}));
}

TEST(ResponseTime, does_not_depend_on_the_order_of_the_messages) {
    const Stream streams[] = {{3, ms, 7 * ms / 2, 0}, {1, ms, 5 * ms / 2, 0}, {2, ms, 7 * ms / 2, 0}};
    EXPECT_EQ(times_ms(response_times(streams, {.bit_ns = 8'000})), (std::vector{3.5, 2.0, 3.0}));
}

TEST(ResponseTime, of_a_message_alone_is_its_frame) {
    const Stream streams[] = {{1, ms, 10 * ms, 2 * ms}};
    EXPECT_EQ(times_ms(response_times(streams, {.bit_ns = 8'000})), (std::vector{3.0}));  // with its jitter
    EXPECT_TRUE(response_times({}, {.bit_ns = 8'000}).empty());
}

TEST(ResponseTime, counts_the_jitter_of_others) {
    // Two frames of the first come close together: one late, the next one in time.
    const Stream streams[] = {{1, ms, 4 * ms, 3 * ms}, {2, ms, 20 * ms, 0}};
    EXPECT_EQ(times_ms(response_times(streams, {.bit_ns = 8'000})), (std::vector{5.0, 3.0}));
}

TEST(ResponseTime, messages_of_one_priority_delay_each_other) {
    const Stream streams[] = {{1, ms, 10 * ms, 0}, {1, 2 * ms, 10 * ms, 0}, {2, ms, 10 * ms, 0}};
    EXPECT_EQ(times_ms(response_times(streams, {.bit_ns = 8'000})), (std::vector{4.0, 4.0, 4.0}));
}

TEST(ResponseTime, has_no_bound_when_the_bus_is_full) {
    const Stream streams[] = {
        {1, ms, 2 * ms, 0}, {2, ms, 4 * ms, 0}, {3, ms, 4 * ms, 0}, {4, ms, 1000 * ms, 0}};
    const std::vector<Response> found = response_times(streams, {.bit_ns = 8'000});
    EXPECT_EQ(found[0].bound, Bound::found);
    EXPECT_EQ(found[1].bound, Bound::found);
    EXPECT_EQ(found[2].bound, Bound::none);  // exactly all of it
    EXPECT_EQ(found[3].bound, Bound::none);
}

TEST(ResponseTime, errors_cost_31_bits_and_the_longest_frame) {
    const Stream streams[] = {{1, ms, 100 * ms, 0}, {2, ms / 2, 100 * ms, 0}};
    const Disturbance rare{.bit_ns = 8'000, .error_interval_ns = 1000 * ms};
    const double error = 31 * 0.008 + 1;
    EXPECT_EQ(times_ms(response_times(streams, rare)), (std::vector{1.5 + error, 1.5 + error}));
    const Disturbance always{.bit_ns = 8'000, .error_interval_ns = ms};
    EXPECT_EQ(response_times(streams, always)[0].bound, Bound::none);
}

TEST(ResponseTime, more_errors_never_make_it_shorter) {
    std::mt19937 random(3);
    std::vector<Stream> streams;
    for (std::uint32_t i = 0; i < 30; ++i) {
        streams.push_back({i, (random() % 80 + 55) * 8'000, (random() % 90 + 60) * ms, random() % ms});
    }
    std::vector<Response> before = response_times(streams, {.bit_ns = 8'000});
    for (const std::uint64_t interval : {10'000 * ms, 1'000 * ms, 100 * ms, 20 * ms}) {
        const std::vector<Response> now = response_times(streams, {8'000, interval});
        for (std::size_t i = 0; i < now.size(); ++i) {
            ASSERT_TRUE(now[i].bound != Bound::found || now[i].time_ns >= before[i].time_ns);
        }
        before = now;
    }
}

// Whatever the numbers are, it ends soon and says when it found nothing.
TEST(ResponseTime, survives_hostile_numbers) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t values[] = {0, 1, 2, 999, ms, std::uint64_t{1} << 40U, most - 1, most};
    std::mt19937 random(4);
    const auto any = [&] { return values[random() % std::size(values)]; };
    for (int round = 0; round < 40; ++round) {
        std::vector<Stream> streams(random() % 20 + 1);
        for (Stream& stream : streams) {
            stream = {static_cast<std::uint32_t>(random() % 8), any() % (1U << 29U), any(), any()};
        }
        const std::vector<Response> found = response_times(streams, {any(), any()});
        ASSERT_EQ(found.size(), streams.size());
    }
}

TEST(ResponseTime, of_thousands_of_messages_takes_no_time_worth_mentioning) {
    std::mt19937 random(5);
    const auto measure = [&](auto make) {
        std::vector<Stream> streams;
        for (std::uint32_t i = 0; i < 4'000; ++i) {
            streams.push_back(make(i));
        }
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(response_times(streams, {.bit_ns = 1'000}).size(), streams.size());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    constexpr double limit_s = 20;  // with sanitizers, on a busy machine; a tenth of it without
    // All periods differ, the bus is not full.
    EXPECT_LT(measure([&](std::uint32_t i) {
                  return Stream{i % 2048, 135'000, (1'000 + i) * ms, 0};
              }),
              limit_s);
    // Nearly full from the first message on: long busy periods.
    EXPECT_LT(measure([&](std::uint32_t i) {
                  return Stream{i, 135'000, i == 0 ? 135'001U : 1'000'000 * ms * (i + 1), 0};
              }),
              limit_s);
    // Jitter of hours and periods of a microsecond: thousands of millions of instances.
    EXPECT_LT(measure([&](std::uint32_t i) { return Stream{i, 1, 1'000'000 + i, 1'000'000 * ms}; }), limit_s);
}

}  // namespace cgw::network
