// The gateway between a simulated CAN1 and a CAN2 that is the test, in a time that is the test's.
#include "runtime/gateway_node.hpp"

#include "fake_channel.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::runtime {
namespace {

using Lines = std::vector<std::string>;
using cgw::test::make_frame;
constexpr Time second = 1'000'000;

class GatewayOnChannels : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(image::Image::open(bytes_, image_), image::Status::ok);
        auto channel = std::make_unique<test::FakeChannel>();
        can2 = channel.get();
        node.emplace(image_, Connection{"simulated", nullptr}, Connection{"test", std::move(channel)},
                     std::uint8_t{7}, events);
        ASSERT_EQ(node->status(), device::OpenStatus::ok);
    }

    // As a loop does: whenever the node wants it, and at the end.
    void pass(Time time) {
        const Time until = now + time;
        while (now < until) {
            now = std::min(until, std::max(now, node->deadline()));
            serve();
        }
    }
    void serve() {
        std::vector<pollfd> entries;
        node->watch(entries);
        node->service(entries, now);
    }
    void hear(const frame::Frame& frame) {
        can2->incoming.push_back(frame);
        serve();
    }
    void start() {
        pass(second);
        hear(make_frame(0, {1, 0}));
        events.take();
        can2->take();
    }
    std::vector<std::uint32_t> sent_ids() {
        std::vector<std::uint32_t> ids;
        for (const frame::Frame& frame : can2->take()) {
            ids.push_back(frame.id);
        }
        return ids;
    }

    cgw::test::SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
    test::EventLog events;
    test::FakeChannel* can2 = nullptr;
    std::optional<GatewayNode> node;
    Time now = 77 * second;
};

TEST_F(GatewayOnChannels, boots_up_once_its_governor_has_initialised_it) {
    pass(second);
    EXPECT_EQ(events.take(), (Lines{"CAN2 up there", "state Init", "state Pre-Operational"}));
    const auto sent = can2->take();
    ASSERT_FALSE(sent.empty());
    EXPECT_EQ(sent.front(), make_frame(0x705, {0}));
    const Diagnosis diagnosis = node->diagnosis();
    EXPECT_EQ(diagnosis.can2.sent, sent.size());
    EXPECT_EQ(diagnosis.governors_heard, 1U << 3);
    EXPECT_GT(diagnosis.can1.received, 60U);
    EXPECT_LE(events.frames[0], diagnosis.can1.received + diagnosis.can1.sent);  // a few still wait for CAN1
    EXPECT_GE(events.frames[0] + 5, diagnosis.can1.received + diagnosis.can1.sent);
    EXPECT_EQ(events.frames[1], sent.size());
}

TEST_F(GatewayOnChannels, answers_and_sends_process_data) {
    start();
    hear(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    EXPECT_EQ(can2->take().back(), make_frame(0x585, {0x43, 0x00, 0x10, 0, 0x91, 0x01, 0x02, 0x00}));
    pass(100'000);
    const auto ids = sent_ids();
    const auto tpdo4 = std::count(ids.begin(), ids.end(), 0x485U);
    EXPECT_GE(tpdo4, 5);  // every 15.625 ms
    EXPECT_LE(tpdo4, 8);
}

TEST_F(GatewayOnChannels, shows_3072_while_can2_is_away_and_comes_back) {
    start();
    can2->set_up(false);
    serve();
    EXPECT_EQ(events.take(), (Lines{"CAN2 down gone", "error 3072 ErrCanBus2", "state Pre-Operational"}));
    EXPECT_FALSE(node->diagnosis().can2.up);
    pass(3 * second);
    EXPECT_TRUE(can2->take().empty());
    hear(make_frame(0, {1, 0}));  // cannot come, but would not lead to Operational either
    EXPECT_EQ(node->gateway().state(), device::GatewayState::pre_operational);
    can2->set_up(true);
    pass(100'000);
    EXPECT_EQ(events.take(), Lines{"CAN2 up there"});
    EXPECT_FALSE(can2->take().empty());  // the sign of life that waited
    hear(make_frame(0, {1, 0}));
    EXPECT_EQ(events.take(), (Lines{"state Operational", "cleared 3072 ErrCanBus2"}));
    EXPECT_EQ(node->gateway().errors().sentinels()[2], 1);
}

TEST_F(GatewayOnChannels, begins_with_3072_when_can2_is_not_there_at_all) {
    can2->set_up(false);
    pass(second);
    EXPECT_EQ(events.take(),
              (Lines{"CAN2 down gone", "error 3072 ErrCanBus2", "state Init", "state Pre-Operational"}));
}

TEST_F(GatewayOnChannels, takes_lost_frames_for_an_overflow_and_is_initialised_anew) {
    start();
    can2->lost = 12;
    pass(second);
    EXPECT_EQ(events.take(), (Lines{"lost 12", "error 3073 ErrCanComm2", "state Undefined", "state Init",
                                    "state Pre-Operational"}));
    EXPECT_EQ(node->diagnosis().can2.lost, 12U);
}

TEST_F(GatewayOnChannels, sends_what_had_no_room_as_soon_as_there_is_room) {
    start();
    can2->room = 0;
    hear(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}));
    pass(50'000);
    EXPECT_TRUE(can2->take().empty());
    EXPECT_TRUE(node->gateway().pending());
    can2->make_room(1);
    serve();
    EXPECT_EQ(sent_ids(), std::vector<std::uint32_t>{0x585});
    can2->make_room(100);
    serve();
    const auto ids = sent_ids();
    EXPECT_EQ(std::count(ids.begin(), ids.end(), 0x485U), 1);  // its newest words, once
    EXPECT_FALSE(node->gateway().pending());
}

TEST_F(GatewayOnChannels, does_not_ask_for_attention_while_nothing_is_to_be_done) {
    start();
    can2->set_up(false);
    pass(second);
    can2->room = 0;
    int turns = 0;
    for (const Time until = now + second; now < until; ++turns) {
        now = std::max(now, node->deadline());
        serve();
    }
    EXPECT_LT(turns, 1000);  // some 75 frames a second on CAN1, begun and ended, and as many cycles
}

TEST_F(GatewayOnChannels, does_not_replay_the_time_in_which_the_program_stood_still) {
    start();
    const std::size_t before = events.frames[0];
    now += 3600 * second;
    serve();
    EXPECT_EQ(events.take(), Lines{"left out 3600000000"});
    EXPECT_LT(events.frames[0] - before, 10U);
    pass(second / 4);
    EXPECT_EQ(node->gateway().state(), device::GatewayState::operational);
    EXPECT_GT(events.frames[0] - before, 20U);
}

TEST_F(GatewayOnChannels, lives_through_a_short_stall_in_full) {
    start();
    const std::size_t before = events.frames[0];
    now += second / 2;
    serve();
    EXPECT_GT(events.frames[0] - before, 32U);  // a cycle telegram every 15.625 ms at least
}

TEST_F(GatewayOnChannels, tells_what_the_channel_knows_of_the_bit_rate) {
    EXPECT_EQ(node->bit_rate(Side::can1), std::nullopt);
    EXPECT_EQ(node->bit_rate(Side::can2), std::nullopt);
    can2->rate = 250'000;
    EXPECT_EQ(node->bit_rate(Side::can2), 250'000U);
}

}  // namespace
}  // namespace cgw::runtime
