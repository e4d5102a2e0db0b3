#include "media/socketcan_channel.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

#include "channel_events.hpp"
#include "media/socketcan_frame.hpp"
#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using test::ChannelEvents;
using test::Events;
using test::make_frame;

// An interface without a kernel behind it: one end of a pair of sockets that keep records whole.
class Interface {
  public:
    CanSocket open() {
        ++attempts;
        if (!reason.empty()) {
            return {Descriptor(), reason, false};
        }
        std::array<int, 2> ends{};
        EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
        bus_ = Descriptor(ends[0]);
        return {Descriptor(ends[1]), {}, false};
    }

    void put(const can_frame& raw) {
        EXPECT_EQ(::send(bus_.get(), &raw, sizeof raw, 0), ssize_t{sizeof raw});
    }
    void put(const frame::Frame& frame) { put(to_kernel_frame(frame)); }
    void put_error(canid_t classes, std::uint8_t controller_status = 0) {
        can_frame raw{};
        raw.can_id = CAN_ERR_FLAG | classes;
        raw.len = CAN_ERR_DLC;
        raw.data[1] = controller_status;
        put(raw);
    }
    void put_bytes(std::size_t count) {
        const std::array<char, 64> bytes{};
        EXPECT_EQ(::send(bus_.get(), bytes.data(), count, 0), static_cast<ssize_t>(count));
    }
    std::optional<frame::Frame> get() {
        can_frame raw{};
        return ::recv(bus_.get(), &raw, sizeof raw, 0) == ssize_t{sizeof raw}
                   ? std::optional(from_kernel_frame(raw))
                   : std::nullopt;
    }
    void remove(std::string why) {
        reason = std::move(why);
        bus_.close();
    }

    std::string reason;  // why it cannot be opened; empty: it can
    int attempts = 0;

  private:
    Descriptor bus_;
};

class SocketCan : public testing::Test {
  protected:
    void service(Time now) { channel.service(now, events); }
    void connect() {
        service(0);
        events.take();
    }

    Interface interface;
    ChannelEvents events;
    SocketCanChannel channel{"can0", [this](const std::string&) { return interface.open(); }};
};

TEST_F(SocketCan, connects_in_the_first_service_and_says_so) {
    EXPECT_EQ(channel.descriptor(), -1);
    EXPECT_EQ(channel.deadline(), 0U);
    EXPECT_FALSE(channel.send(make_frame(1, {})));
    service(0);
    EXPECT_EQ(events.take(), Events{"up can0: the interface is up"});
    EXPECT_GE(channel.descriptor(), 0);
    EXPECT_EQ(channel.events(), POLLIN);
    EXPECT_EQ(channel.deadline(), never);
}

TEST_F(SocketCan, takes_all_frames_that_came) {
    connect();
    interface.put(make_frame(0x181, {1, 2}));
    frame::Frame remote;
    remote.id = 0x705;
    remote.remote = true;
    interface.put(remote);
    frame::Frame extended = make_frame(0x12345, {9});
    extended.extended = true;
    interface.put(extended);
    service(10);
    EXPECT_EQ(events.take(), (Events{"frame 181#0102", "frame 705#R", "frame 00012345#09"}));
    service(20);
    EXPECT_EQ(events.take(), Events{});
}

TEST_F(SocketCan, sends_at_once) {
    connect();
    EXPECT_TRUE(channel.send(make_frame(0x701, {5})));
    EXPECT_EQ(interface.get(), make_frame(0x701, {5}));
}

TEST_F(SocketCan, says_not_now_when_the_queue_is_full_and_wants_service_soon) {
    connect();
    service(50);
    int taken = 0;
    while (taken < 100'000 && channel.send(make_frame(0x181, {1}))) {
        ++taken;
    }
    ASSERT_LT(taken, 100'000);
    EXPECT_EQ(channel.deadline(), 1'050U);
    EXPECT_EQ(events.take(), Events{});
    for (int i = 0; i < taken; ++i) {
        ASSERT_TRUE(interface.get());
    }
    service(1'050);
    EXPECT_EQ(channel.deadline(), never);
    EXPECT_TRUE(channel.send(make_frame(0x182, {2})));
    EXPECT_EQ(interface.get(), make_frame(0x182, {2}));
}

TEST_F(SocketCan, tells_a_lost_interface_after_the_frames_that_came_before) {
    connect();
    interface.put(make_frame(0x181, {1}));
    interface.remove("the interface is down");
    service(10);
    EXPECT_EQ(events.take(), (Events{"frame 181#01", "down can0: there is no such interface"}));
    EXPECT_EQ(channel.descriptor(), -1);
    EXPECT_FALSE(channel.send(make_frame(1, {})));
}

TEST_F(SocketCan, finds_a_lost_interface_when_it_sends) {
    connect();
    service(10);
    interface.remove("");
    EXPECT_FALSE(channel.send(make_frame(1, {})));
    EXPECT_LE(channel.deadline(), 10U);
    service(20);
    ASSERT_EQ(events.events.size(), 1U);
    EXPECT_TRUE(events.events.front().starts_with("down can0: "));
    EXPECT_EQ(channel.descriptor(), -1);
}

TEST_F(SocketCan, comes_back_with_the_interface) {
    connect();
    interface.remove("");
    service(10);
    events.take();
    service(channel.deadline() - 1);
    EXPECT_EQ(events.take(), Events{});
    service(channel.deadline());
    EXPECT_EQ(events.take(), Events{"up can0: the interface is up"});
    interface.put(make_frame(0x181, {3}));
    service(channel.deadline());
    EXPECT_EQ(events.take(), Events{"frame 181#03"});
    EXPECT_TRUE(channel.send(make_frame(1, {})));
}

TEST_F(SocketCan, tries_again_at_growing_distances_of_at_most_a_second) {
    interface.reason = "the interface is down";
    std::vector<Time> pauses;
    Time now = 0;
    for (int i = 0; i < 8; ++i) {
        service(now);
        pauses.push_back(channel.deadline() - now);
        now = channel.deadline();
    }
    EXPECT_EQ(pauses, (std::vector<Time>{50'000, 100'000, 200'000, 400'000, 800'000, 1'000'000, 1'000'000,
                                         1'000'000}));
    EXPECT_EQ(interface.attempts, 8);
}

TEST_F(SocketCan, says_once_why_it_is_not_connected_and_again_when_that_changes) {
    interface.reason = "the interface is down";
    service(0);
    service(channel.deadline());
    interface.reason = "there is no such interface";
    service(channel.deadline());
    service(channel.deadline());
    EXPECT_EQ(events.take(),
              (Events{"down can0: the interface is down", "down can0: there is no such interface"}));
}

TEST_F(SocketCan, is_down_while_the_controller_is_bus_off) {
    connect();
    interface.put_error(CAN_ERR_BUSOFF);
    interface.reason = "the controller is bus-off";
    service(10);
    EXPECT_FALSE(channel.send(make_frame(1, {})));
    service(channel.deadline());
    EXPECT_EQ(events.take(), Events{"down can0: the controller is bus-off"});
    interface.reason.clear();
    service(channel.deadline());
    EXPECT_EQ(events.take(), Events{"up can0: the interface is up"});
}

TEST_F(SocketCan, tells_a_controller_that_becomes_error_passive_and_recovers) {
    connect();
    interface.put_error(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE);  // it was not passive
    interface.put_error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE);
    interface.put_error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE | CAN_ERR_CRTL_RX_PASSIVE);
    interface.put_error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING);
    service(10);
    EXPECT_EQ(
        events.take(),
        (Events{"up can0: the controller is error-passive: nobody acknowledges, or the bus is disturbed",
                "up can0: the controller is error-active again"}));
    EXPECT_TRUE(channel.send(make_frame(1, {})));
}

TEST_F(SocketCan, counts_a_frame_for_which_the_controller_had_no_room) {
    connect();
    interface.put_error(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW);
    service(10);
    EXPECT_EQ(events.take(), Events{"lost 1"});
}

TEST_F(SocketCan, passes_over_records_that_are_no_classic_frames) {
    connect();
    interface.put_bytes(sizeof(can_frame) - 1);
    interface.put(make_frame(0x181, {1}));
    service(10);
    EXPECT_EQ(events.take(), Events{"frame 181#01"});
}

TEST(OpenSocketCan, says_clearly_why_it_cannot_be_opened) {
    const base::Result<std::unique_ptr<Channel>> opened = open_socketcan("nosuchcan0");
    const bool supported = Descriptor(::socket(AF_CAN, SOCK_RAW, CAN_RAW)).get() >= 0;
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().message, supported ? "nosuchcan0: there is no such interface"
                                                : "nosuchcan0: this kernel has no CAN support");
}

TEST(OpenSocketCan, refuses_an_interface_that_is_no_can_interface) {
    const base::Result<std::unique_ptr<Channel>> opened = open_socketcan("lo");
    const bool supported = Descriptor(::socket(AF_CAN, SOCK_RAW, CAN_RAW)).get() >= 0;
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().message,
              supported ? "lo: it is no CAN interface" : "lo: this kernel has no CAN support");
}

}  // namespace
}  // namespace cgw::media
