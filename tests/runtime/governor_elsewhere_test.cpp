// CAN1 as a channel, with a governor at its other end that is no part of the gateway.
#include "fake_channel.hpp"
#include "runtime/gateway_node.hpp"
#include "support/governor_on_channel.hpp"
#include "support/recording_port.hpp"
#include "support/sample_plant.hpp"

namespace cgw::runtime {
namespace {

using Lines = std::vector<std::string>;
using cgw::test::make_frame;
constexpr Time second = 1'000'000;

class GovernorElsewhere : public testing::Test {
  protected:
    void begin() {
        ASSERT_EQ(image::Image::open(gateway_bytes_ = plant_.image(), gateway_image_), image::Status::ok);
        if (governor_bytes_.empty()) {
            governor_bytes_ = gateway_bytes_;
        }
        ASSERT_EQ(image::Image::open(governor_bytes_, governor_image_), image::Status::ok);
        auto first = std::make_unique<test::FakeChannel>();
        auto second_channel = std::make_unique<test::FakeChannel>();
        can1 = first.get();
        can2 = second_channel.get();
        node.emplace(gateway_image_, Connection{"one", std::move(first)},
                     Connection{"two", std::move(second_channel)}, std::uint8_t{1}, events);
        governor.emplace(governor_image_, far_end, now);
    }
    void serve(media::Source& source) {
        std::vector<pollfd> entries;
        source.watch(entries);
        source.service(entries, now);
    }
    void carry() {
        for (const frame::Frame& frame : can1->take()) {
            far_end.incoming.push_back(frame);
        }
        for (const frame::Frame& frame : far_end.take()) {
            if (can1->up) {
                can1->incoming.push_back(frame);
            }
        }
    }
    void pass(Time time) {
        for (const Time until = now + time; now < until;) {
            now = std::min(until, std::max(now + 1, std::min(node->deadline(), governor->deadline())));
            serve(*node);
            carry();
            serve(*governor);
            carry();
        }
    }

    cgw::test::SamplePlant plant_;
    base::Bytes gateway_bytes_;
    base::Bytes governor_bytes_;
    image::Image gateway_image_;
    image::Image governor_image_;
    test::EventLog events;
    test::FakeChannel far_end;
    test::FakeChannel* can1 = nullptr;
    test::FakeChannel* can2 = nullptr;
    std::optional<GatewayNode> node;
    std::optional<cgw::test::GovernorOnChannel> governor;
    Time now = 1000 * second;
};

TEST_F(GovernorElsewhere, initialises_the_gateway_over_the_channel) {
    begin();
    pass(second);
    EXPECT_EQ(events.take(),
              (Lines{"CAN1 up there", "CAN2 up there", "state Init", "state Pre-Operational"}));
    EXPECT_EQ(governor->governor().link().phase(), link::GovernorEnd::Phase::running);
    EXPECT_EQ(node->diagnosis().governors_heard, 1U << 3);
}

TEST_F(GovernorElsewhere, is_missed_when_can1_goes_away_and_found_again) {
    begin();
    pass(second);
    events.take();
    can1->set_up(false);
    pass(2 * second);
    EXPECT_EQ(events.take(), (Lines{"CAN1 down gone", "error 3070 ErrCanBus1", "state Undefined",
                                    "error 3071 ErrCanComm1"}));
    EXPECT_EQ(node->diagnosis().governors_heard, 0U);
    can1->set_up(true);
    pass(second);
    EXPECT_EQ(events.take(), (Lines{"CAN1 up there", "error 12415 CanOpDCErrCanComm", "state Init",
                                    "state Pre-Operational"}));  // the governor has missed the gateway too
    can2->incoming.push_back(make_frame(0, {1, 5}));
    pass(10'000);
    EXPECT_EQ(events.take(), (Lines{"state Operational", "cleared 3070 ErrCanBus1",
                                    "cleared 3071 ErrCanComm1", "cleared 12415 CanOpDCErrCanComm"}));
}

TEST_F(GovernorElsewhere, is_refused_with_the_reason_when_it_has_another_configuration) {
    plant_.rpdo(2).time = {120, 7, 7 * 15625};
    governor_bytes_ = plant_.image();
    plant_.rpdo(2).time = {100, 6, 93750};
    begin();
    pass(5 * second);
    const Lines lines = events.take();
    const std::string refusal = line_of_refusal({false, {link::ItemKind::monitoring, 1, 6}, 7});
    EXPECT_EQ(std::count(lines.begin(), lines.end(), refusal), 3);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), "error 12412 CanOpInitErr"), 1);
    EXPECT_EQ(node->gateway().state(), device::GatewayState::undefined);
    node->clear_errors(now);  // three more attempts
    pass(5 * second);
    const Lines again = events.take();
    EXPECT_EQ(again.front(), "cleared 12412 CanOpInitErr");
    EXPECT_EQ(std::count(again.begin(), again.end(), refusal), 3);
}

}  // namespace
}  // namespace cgw::runtime
