#include <gtest/gtest.h>

#include <random>

#include "network/frame_bits.hpp"
#include "network/simulated_bus.hpp"

namespace cgw::network {
namespace {

using network_test::Frame;
using network_test::longest_responses;

constexpr std::uint64_t bit_ns = 8'000;  // 125 kbit/s
constexpr std::uint64_t ms = 1'000'000;

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    std::uint32_t operator()() { return static_cast<std::uint32_t>(random_()); }

  private:
    std::mt19937 random_;
};

// A bus of `count` messages with a load below `load`; every second one with jitter.
std::vector<Stream> random_streams(Dice& random, unsigned count, double load, bool jitter) {
    std::vector<Stream> streams;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t cost = worst_case_bits(random() % 9) * bit_ns;
        const double share = load / count * (0.3 + 0.7 * (random() % 100) / 100);
        const auto period = static_cast<std::uint64_t>(static_cast<double>(cost) / share);
        streams.push_back({i * 7, cost, period, jitter && i % 2 == 0 ? random() % (period / 2) : 0});
    }
    return streams;
}

std::uint64_t bound_of(const Response& response) {
    return response.bound == Bound::found ? response.time_ns : ~std::uint64_t{0};
}

}  // namespace

// Random phases, jitters and lengths of frames: no frame is later than its bound.
TEST(SimulatedBus, never_exceeds_the_bounds) {
    Dice random(11);
    for (int round = 0; round < 120; ++round) {
        const std::vector<Stream> streams =
            random_streams(random, random() % 20 + 2, 0.5 + 0.45 * (round % 10) / 10, round % 2 == 0);
        const std::vector<Response> bounds = response_times(streams, {.bit_ns = bit_ns});
        const auto frames_of = [&](std::size_t i) {
            const Stream& stream = streams[i];
            std::vector<Frame> frames;
            const std::uint64_t phase = random() % stream.period_ns;
            for (std::uint64_t due = phase; due < 2'000 * ms; due += stream.period_ns) {
                const std::uint64_t late = stream.jitter_ns == 0 ? 0 : random() % (stream.jitter_ns + 1);
                frames.push_back({due, due + late, stream.cost_ns - random() % (stream.cost_ns / 3)});
            }
            return frames;
        };
        const std::vector<std::uint64_t> longest = longest_responses(streams, frames_of);
        for (std::size_t i = 0; i < streams.size(); ++i) {
            EXPECT_LE(longest[i], bound_of(bounds[i])) << "round " << round << " message " << i;
        }
    }
}

// Frames as long as they can be, all released together just after the longest one behind them has begun:
// every message comes within 10 % of its bound, and not beyond it.
TEST(SimulatedBus, comes_close_to_the_bounds_when_all_is_released_together) {
    Dice random(12);
    for (int round = 0; round < 60; ++round) {
        const std::vector<Stream> streams = random_streams(random, random() % 20 + 2, 0.9, false);
        const std::vector<Response> bounds = response_times(streams, {.bit_ns = bit_ns});
        for (std::size_t judged = 0; judged < streams.size(); ++judged) {
            std::size_t blocking = judged;  // the longest of lower priority, else none
            for (std::size_t i = judged + 1; i < streams.size(); ++i) {
                if (blocking == judged || streams[i].cost_ns > streams[blocking].cost_ns) {
                    blocking = i;
                }
            }
            const auto frames_of = [&](std::size_t i) {
                std::vector<Frame> frames;
                if (i > judged && i != blocking) {
                    return frames;
                }
                const std::uint64_t begin = i > judged ? 0 : 1;
                const std::uint64_t end = i > judged ? 1 : 1'000 * ms;
                for (std::uint64_t due = begin; due < end; due += streams[i].period_ns) {
                    frames.push_back({due, due, streams[i].cost_ns});
                }
                return frames;
            };
            const std::uint64_t longest = longest_responses(streams, frames_of)[judged];
            ASSERT_EQ(bounds[judged].bound, Bound::found);
            EXPECT_LE(longest, bounds[judged].time_ns) << "round " << round << " message " << judged;
            EXPECT_GE(static_cast<double>(longest), 0.9 * static_cast<double>(bounds[judged].time_ns))
                << "round " << round << " message " << judged;
        }
    }
}

// The counterexample again, as it happens.
TEST(SimulatedBus, shows_the_counterexample_of_davis) {
    const std::vector<Stream> streams{{1, ms, 5 * ms / 2, 0}, {2, ms, 7 * ms / 2, 0}, {3, ms, 7 * ms / 2, 0}};
    const auto frames_of = [&](std::size_t i) {
        std::vector<Frame> frames;
        for (std::uint64_t due = 0; due < 100 * ms; due += streams[i].period_ns) {
            frames.push_back({due, due, streams[i].cost_ns});
        }
        return frames;
    };
    EXPECT_EQ(longest_responses(streams, frames_of)[2], 7 * ms / 2);
}

}  // namespace cgw::network
