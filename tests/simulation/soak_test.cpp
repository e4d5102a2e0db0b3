// Hours and days of simulated time with random disturbances, while the rules of soak/rules.hpp watch. After
// each round everything is mended, and then the plant must be as it was before. Seeds are fixed, so that a
// failure comes again. CGW_SOAK_HOURS sets the simulated time, CGW_SOAK_SEED the first seed.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "simulation/soak/disturbances.hpp"
#include "simulation/soak/world.hpp"

namespace cgw::simulation::soak {
namespace {

// Returns what it did.
std::string disturb(World& world, const std::vector<Disturbance>& all) {
    std::vector<const Disturbance*> chosen;
    std::string what;
    for (std::uint32_t i = 1 + world.below(3); i > 0; --i) {
        const Disturbance& next = all[world.below(static_cast<std::uint32_t>(all.size()))];
        chosen.push_back(&next);
        what += next.name + ", ";
        world.rules().allow(next.errors);
        world.rules().allow_alarms(next.alarms);
        next.begin(world);
        world.run_for(world.below(2'000'000 + static_cast<std::uint32_t>(next.lasts)));
    }
    for (std::uint32_t i = world.below(20); i > 0; --i) {
        chosen[world.below(static_cast<std::uint32_t>(chosen.size()))]->again(world);
        world.run_for(world.below(200'000));
    }
    for (const Disturbance* disturbance : chosen) {
        disturbance->end(world);
    }
    return what;
}

// What the rules have seen.
struct Tally {
    std::uint64_t sent = 0;
    std::uint64_t obeyed = 0;
    std::uint64_t refused = 0;
    std::uint64_t boot_ups = 0;
    std::uint64_t alarms = 0;

    void add(const Rules& rules) {
        sent += rules.pdos();
        obeyed += rules.forwarded();
        refused += rules.refused();
        boot_ups += rules.boot_ups();
        alarms += rules.alarms();
    }
    bool complete() const { return sent != 0 && obeyed != 0 && refused != 0 && boot_ups != 0 && alarms != 0; }
    std::string text() const {
        return fmt::format("{} transmit PDOs, {} receive PDOs, {} refusals, {} boot-ups, {} alarms", sent,
                           obeyed, refused, boot_ups, alarms);
    }
};

Time soak_time() {
    constexpr Time usual = 600 * second;
    const char* hours = std::getenv("CGW_SOAK_HOURS");
    return hours == nullptr ? usual : static_cast<Time>(std::atof(hours) * 3600) * second;
}

TEST(Soak, of_random_disturbances_breaks_no_rule) {
    const std::vector<Disturbance> all = disturbances();
    Time simulated = 0;
    std::uint64_t frames = 0;
    Tally tally;
    unsigned rounds = 0;
    const char* first = std::getenv("CGW_SOAK_SEED");
    for (unsigned seed = first == nullptr ? 1U : static_cast<unsigned>(std::atoi(first));
         simulated < soak_time(); ++seed) {
        World world(seed);
        world.recover();
        for (int round = 0; round < 20 && simulated + world.plant().now() < soak_time(); ++round, ++rounds) {
            const std::string what = disturb(world, all);
            world.recover();
            ASSERT_TRUE(world.rules().broken().empty()) << fmt::format(
                "{}\n{} s after the start, seed {}, round {}: {}at {}",
                fmt::join(world.rules().broken(), "\n"), (simulated + world.plant().now()) / second, seed,
                round, what, world.plant().now());
            world.rules().allow_none();
        }
        simulated += world.plant().now();
        frames += world.plant().can1().frames() + world.plant().can2().frames();
        tally.add(world.rules());
    }
    std::cout << fmt::format("{} s simulated, {} rounds, {} frames, {}\n", simulated / second, rounds, frames,
                             tally.text());
    // Otherwise the rules had nothing to look at.
    EXPECT_TRUE(tally.complete()) << tally.text();
}

}  // namespace
}  // namespace cgw::simulation::soak
