#include "simulation/bus.hpp"

#include "simulation/frame_time.hpp"
#include "simulation/jammer.hpp"
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

TEST(BusConnection, of_nobody_says_not_now_and_keeps_what_waits) {
    Bus bus(500);
    Node sender(bus);
    Node listener(bus);
    std::size_t observed = 0;
    bus.observe([&observed](const frame::Frame&, Time) { ++observed; });
    sender.plan.emplace_back(10, make_frame(0x100, {}));
    sender.plan.emplace_back(10, make_frame(0x101, {}));
    sender.plan.emplace_back(1'000, make_frame(0x102, {}));
    bus.run_until(20);  // the first is on the wire, the second waits
    bus.connect(false);
    EXPECT_FALSE(bus.connected());
    bus.run_until(10'000);
    EXPECT_TRUE(listener.heard.empty());
    EXPECT_EQ(observed, 0U);
    EXPECT_EQ(sender.accepted, 2U);
    bus.connect(true);
    bus.run_until(20'000);
    ASSERT_EQ(listener.heard.size(), 1U);
    EXPECT_EQ(listener.heard[0].second.id, 0x101U);
    EXPECT_EQ(bus.frames(), 1U);
}

TEST(BusConnection, of_one_participant_leaves_the_others_alone) {
    Bus bus(500);
    Node sender(bus);
    Node listener(bus);
    Node cut(bus);
    bus.connect(cut, false);
    sender.plan.emplace_back(10, make_frame(0x100, {}));
    cut.plan.emplace_back(10, make_frame(0x080, {}));
    bus.run_until(1'000);
    EXPECT_EQ(listener.heard.size(), 1U);
    EXPECT_TRUE(cut.heard.empty());
    EXPECT_EQ(cut.accepted, 0U);
    bus.connect(cut, true);
    sender.plan.emplace_back(2'000, make_frame(0x101, {}));
    bus.run_until(3'000);
    EXPECT_EQ(cut.heard.size(), 1U);
}

TEST(BusConnection, lost_by_the_sender_loses_the_frame_on_the_wire) {
    Bus bus(500);
    Node sender(bus);
    Node listener(bus);
    sender.plan.emplace_back(10, make_frame(0x100, {}));
    bus.run_until(20);
    bus.connect(sender, false);
    bus.run_until(1'000);
    EXPECT_TRUE(listener.heard.empty());
}

TEST(BusJammer, fills_the_bus_from_start_to_end_and_no_longer) {
    Bus bus(500);
    Node listener(bus);
    Jammer jammer(bus);
    const frame::Frame frame = make_frame(0x001, {0, 0, 0, 0, 0, 0, 0, 0});
    bus.run_until(10'000);
    EXPECT_TRUE(listener.heard.empty());
    jammer.start(frame, 20'000);
    bus.run_until(40'000);
    const Time length = Time{bits_on_wire(frame)} * 2;
    EXPECT_EQ(listener.heard.front().first, 10'000 + length);
    EXPECT_GE(listener.heard.back().first, 20'000U);
    EXPECT_LT(listener.heard.back().first, 20'000 + 2 * length);
    EXPECT_EQ(bus.busy_time(), listener.heard.size() * length);
}

}  // namespace
}  // namespace cgw::simulation
