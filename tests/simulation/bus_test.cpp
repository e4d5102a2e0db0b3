#include "simulation/bus.hpp"

#include "simulation/frame_time.hpp"
#include "support/recording_port.hpp"

namespace cgw::simulation {
namespace {

using test::make_frame;

// Sends what it is told at the times it is told, and remembers what it heard.
struct Node final : Participant {
    explicit Node(Bus& bus, std::size_t capacity = 16) : port(bus.attach(*this, capacity)) {}

    Time poll(Time now) override {
        ++polls;
        while (!plan.empty() && plan.front().first <= now) {
            accepted += port.send(plan.front().second) ? 1U : 0U;
            plan.pop_front();
        }
        return plan.empty() ? canopen::never : plan.front().first;
    }
    void receive(const frame::Frame& frame, Time now) override { heard.emplace_back(now, frame); }

    frame::FramePort& port;
    std::deque<std::pair<Time, frame::Frame>> plan;
    std::vector<std::pair<Time, frame::Frame>> heard;
    std::size_t accepted = 0;
    std::size_t polls = 0;
};

TEST(Bus, delivers_a_frame_after_its_bit_time_to_all_others) {
    for (const unsigned rate : {125U, 250U, 500U, 1000U}) {
        Bus bus(rate);
        Node sender(bus);
        Node listener(bus);
        Node another(bus);
        const frame::Frame frame = make_frame(0x123, {1, 2, 3});
        sender.plan.emplace_back(100, frame);
        bus.run_until(100'000);
        const Time end = 100 + Time{bits_on_wire(frame)} * (1000 / rate);
        EXPECT_EQ(listener.heard, (std::vector{std::pair{end, frame}}));
        EXPECT_EQ(another.heard, listener.heard);
        EXPECT_TRUE(sender.heard.empty());
        EXPECT_EQ(bus.busy_time(), end - 100);
        EXPECT_EQ(bus.now(), 100'000U);
    }
}

TEST(Bus, lets_the_lowest_identifier_win) {
    Bus bus(500);
    Node listener(bus);
    Node first(bus);
    Node second(bus);
    Node third(bus);
    first.plan.emplace_back(10, make_frame(0x300, {}));
    second.plan.emplace_back(10, make_frame(0x100, {}));
    third.plan.emplace_back(10, make_frame(0x200, {}));
    bus.run_until(10'000);
    std::vector<std::uint32_t> order;
    for (const auto& [time, frame] : listener.heard) {
        order.push_back(frame.id);
    }
    EXPECT_EQ(order, (std::vector<std::uint32_t>{0x100, 0x200, 0x300}));
}

TEST(Bus, compares_identifiers_as_they_stand_on_the_wire) {
    Bus bus(500);
    Node listener(bus);
    Node first(bus);
    Node second(bus);
    Node third(bus);
    frame::Frame extended = make_frame(0x100U << 18, {});
    extended.extended = true;
    frame::Frame remote = make_frame(0x100, {});
    remote.remote = true;
    first.plan.emplace_back(10, extended);
    second.plan.emplace_back(10, remote);
    third.plan.emplace_back(10, make_frame(0x100, {}));
    bus.run_until(10'000);
    ASSERT_EQ(listener.heard.size(), 3U);
    EXPECT_EQ(listener.heard[0].second, make_frame(0x100, {}));
    EXPECT_EQ(listener.heard[1].second, remote);
    EXPECT_EQ(listener.heard[2].second, extended);
}

TEST(Bus, does_not_interrupt_a_frame_for_a_more_important_one) {
    Bus bus(125);
    Node listener(bus);
    Node first(bus);
    Node second(bus);
    first.plan.emplace_back(0, make_frame(0x700, {1, 2, 3, 4, 5, 6, 7, 8}));
    second.plan.emplace_back(1, make_frame(0x001, {}));
    bus.run_until(100'000);
    ASSERT_EQ(listener.heard.size(), 2U);
    EXPECT_EQ(listener.heard[0].second.id, 0x700U);
}

TEST(Bus, keeps_the_order_of_one_nodes_frames) {
    Bus bus(125);
    Node listener(bus);
    Node sender(bus);
    sender.plan.emplace_back(0, make_frame(0x700, {}));
    sender.plan.emplace_back(0, make_frame(0x001, {}));
    bus.run_until(100'000);
    ASSERT_EQ(listener.heard.size(), 2U);
    EXPECT_EQ(listener.heard[0].second.id, 0x700U);
}

TEST(Bus, says_not_now_when_the_queue_is_full_and_polls_when_there_is_room) {
    Bus bus(125);
    Node sender(bus, 2);
    for (int i = 0; i < 5; ++i) {
        sender.plan.emplace_back(0, make_frame(0x100, {}));
    }
    sender.poll(0);
    EXPECT_EQ(sender.accepted, 2U);
    const std::size_t polls = sender.polls;
    bus.run_until(100'000);
    EXPECT_EQ(bus.frames(), 2U);
    EXPECT_GT(sender.polls, polls + 2);
}

TEST(Bus, runs_a_participant_that_only_needs_the_clock) {
    struct Clock final : Participant {
        Time poll(Time now) override {
            times.push_back(now);
            return now + 1000;
        }
        std::vector<Time> times;
    };
    Bus bus(125);
    Clock clock;
    bus.attach_clock(clock);
    bus.run_until(3000);
    EXPECT_EQ(clock.times, (std::vector<Time>{0, 1000, 2000, 3000}));
}

TEST(Bus, shows_every_frame_to_its_observers) {
    Bus bus(125);
    Node sender(bus);
    std::vector<frame::Frame> seen;
    bus.observe([&seen](const frame::Frame& frame, Time) { seen.push_back(frame); });
    sender.plan.emplace_back(0, make_frame(0x100, {7}));
    bus.run_until(100'000);
    EXPECT_EQ(seen, (std::vector{make_frame(0x100, {7})}));
}

}  // namespace
}  // namespace cgw::simulation
