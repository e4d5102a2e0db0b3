#include "canopen/heartbeat.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;

TEST(Heartbeat, sends_the_first_one_a_period_after_boot_up) {
    RecordingPort port;
    HeartbeatProducer producer(3, 1000);
    producer.boot_up();
    EXPECT_TRUE(producer.pending());
    producer.send_due(NmtState::pre_operational, 50, port);
    EXPECT_EQ(port.take(), (std::vector{make_frame(0x703, {0x00})}));
    EXPECT_EQ(producer.deadline(), 1050U);

    producer.send_due(NmtState::pre_operational, 1049, port);
    EXPECT_TRUE(port.take().empty());
    producer.send_due(NmtState::pre_operational, 1050, port);
    EXPECT_EQ(port.take(), (std::vector{make_frame(0x703, {0x7F})}));
    EXPECT_EQ(producer.deadline(), 2050U);
}

TEST(Heartbeat, is_silent_before_boot_up_and_after_silence) {
    RecordingPort port;
    HeartbeatProducer producer(3, 1000);
    EXPECT_TRUE(producer.send_due(NmtState::operational, 99999, port));
    producer.boot_up();
    producer.silence();
    EXPECT_TRUE(producer.send_due(NmtState::operational, 99999, port));
    EXPECT_TRUE(port.sent.empty());
    EXPECT_EQ(producer.deadline(), never);
}

TEST(Heartbeat, sends_only_the_boot_up_when_the_period_is_zero) {
    RecordingPort port;
    HeartbeatProducer producer(3, 0);
    producer.boot_up();
    producer.send_due(NmtState::pre_operational, 10, port);
    producer.send_due(NmtState::pre_operational, 10'000'000, port);
    EXPECT_EQ(port.sent.size(), 1U);
    EXPECT_EQ(producer.deadline(), never);
}

TEST(Heartbeat, counts_the_first_period_from_the_moment_the_boot_up_really_left) {
    RecordingPort port;
    port.room = 0;
    HeartbeatProducer producer(3, 1000);
    producer.boot_up();
    EXPECT_FALSE(producer.send_due(NmtState::pre_operational, 0, port));
    EXPECT_TRUE(producer.pending());
    port.room = RecordingPort::unlimited;
    EXPECT_TRUE(producer.send_due(NmtState::pre_operational, 700, port));
    EXPECT_EQ(producer.deadline(), 1700U);
    EXPECT_EQ(port.sent.size(), 1U);
}

TEST(Heartbeat, offers_a_refused_one_again_with_the_newest_state_and_keeps_its_rhythm) {
    RecordingPort port;
    HeartbeatProducer producer(3, 1000);
    producer.boot_up();
    producer.send_due(NmtState::pre_operational, 0, port);
    port.take();
    port.room = 0;
    EXPECT_FALSE(producer.send_due(NmtState::pre_operational, 1000, port));
    EXPECT_TRUE(producer.pending());
    EXPECT_EQ(producer.deadline(), never);  // time alone changes nothing: the port has to get room
    port.room = RecordingPort::unlimited;
    EXPECT_TRUE(producer.send_due(NmtState::operational, 1300, port));
    EXPECT_EQ(port.take(), (std::vector{make_frame(0x703, {0x05})}));
    EXPECT_EQ(producer.deadline(), 2000U);
    EXPECT_FALSE(producer.pending());
}

TEST(Heartbeat, does_not_make_up_for_missed_ones) {
    RecordingPort port;
    HeartbeatProducer producer(3, 1000);
    producer.boot_up();
    producer.send_due(NmtState::pre_operational, 0, port);
    port.take();
    producer.send_due(NmtState::stopped, 5400, port);
    producer.send_due(NmtState::stopped, 5401, port);
    EXPECT_EQ(port.take(), (std::vector{make_frame(0x703, {0x04})}));
    EXPECT_EQ(producer.deadline(), 6000U);
}

TEST(Heartbeat, keeps_its_rhythm_past_32_bits_and_begins_a_new_one_after_hours_of_silence) {
    constexpr Time before = (Time{1} << 32) - 500;
    RecordingPort port;
    HeartbeatProducer producer(3, 1000);
    producer.boot_up();
    producer.send_due(NmtState::operational, before, port);
    producer.send_due(NmtState::operational, before + 3100, port);
    EXPECT_EQ(producer.deadline(), before + 4000);
    constexpr Time later = before + (Time{3} << 32) + 70;
    EXPECT_TRUE(producer.send_due(NmtState::operational, later, port));
    EXPECT_EQ(producer.deadline(), later + 1000);
}

}  // namespace
}  // namespace cgw::canopen
