#include "canopen/slave_test.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;
using Kind = Slave::Event::Kind;

using SlaveTest = test::SlaveTest;

TEST_F(SlaveTest, is_silent_and_deaf_before_boot_up) {
    EXPECT_EQ(slave_.poll(1'000'000), never);
    EXPECT_EQ(command(NmtCommand::start), Kind::none);
    EXPECT_TRUE(upload().empty());
    EXPECT_EQ(slave_.state(), NmtState::initialising);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(SlaveTest, sends_exactly_one_boot_up_and_is_pre_operational) {
    slave_.boot_up();
    for (Time now = 0; now < 100'000; now += 1000) {
        slave_.poll(now);
    }
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x00})}));
    EXPECT_EQ(slave_.state(), NmtState::pre_operational);
}

TEST_F(SlaveTest, shows_each_state_in_its_heartbeat) {
    boot_up();
    command(NmtCommand::start);
    EXPECT_EQ(slave_.poll(100'000), 200'000U);
    command(NmtCommand::stop);
    slave_.poll(200'000);
    command(NmtCommand::enter_pre_operational);
    slave_.poll(300'000);
    EXPECT_EQ(port_.take(),
              (std::vector{make_frame(0x705, {0x05}), make_frame(0x705, {0x04}), make_frame(0x705, {0x7F})}));
}

TEST_F(SlaveTest, changes_its_heartbeat_period_while_it_runs) {
    boot_up();
    slave_.set_heartbeat_period(30'000, 50'000);
    EXPECT_EQ(slave_.poll(79'999), 80'000U);
    EXPECT_EQ(slave_.poll(80'000), 110'000U);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x7F})}));
    slave_.set_heartbeat_period(0, 90'000);
    EXPECT_EQ(slave_.poll(1'000'000), never);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(SlaveTest, changes_its_heartbeat_period_before_its_boot_up_left) {
    slave_.set_heartbeat_period(30'000, 0);
    EXPECT_EQ(slave_.poll(1'000'000), never);
    port_.room = 0;
    slave_.boot_up();
    slave_.poll(1'000'000);
    slave_.set_heartbeat_period(40'000, 1'000'000);
    port_.room = RecordingPort::unlimited;
    EXPECT_EQ(slave_.poll(2'000'000), 2'040'000U);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x00})}));
}

TEST_F(SlaveTest, obeys_broadcasts_and_no_command_for_another_node) {
    boot_up();
    EXPECT_EQ(command(NmtCommand::start, 6), Kind::none);
    EXPECT_EQ(slave_.state(), NmtState::pre_operational);
    EXPECT_EQ(command(NmtCommand::start, 0), Kind::state_changed);
    EXPECT_EQ(slave_.state(), NmtState::operational);
}

TEST_F(SlaveTest, obeys_commands_that_follow_each_other_without_a_pause) {
    boot_up();
    EXPECT_EQ(command(NmtCommand::start), Kind::state_changed);
    EXPECT_EQ(command(NmtCommand::stop), Kind::state_changed);
    EXPECT_EQ(command(NmtCommand::enter_pre_operational), Kind::state_changed);
    EXPECT_EQ(command(NmtCommand::start), Kind::state_changed);
    EXPECT_EQ(command(NmtCommand::start), Kind::none);
    EXPECT_EQ(slave_.state(), NmtState::operational);
}

TEST_F(SlaveTest, reports_both_resets_and_waits_for_boot_up) {
    for (const NmtCommand reset : {NmtCommand::reset_node, NmtCommand::reset_communication}) {
        boot_up();
        EXPECT_EQ(command(reset), Kind::reset);
        EXPECT_EQ(slave_.state(), NmtState::initialising);
        EXPECT_EQ(command(reset), Kind::none);
        EXPECT_EQ(slave_.poll(10'000'000), never);
        EXPECT_TRUE(port_.sent.empty());
    }
}

TEST_F(SlaveTest, answers_sdo_in_pre_operational_and_operational_but_not_in_stopped) {
    boot_up();
    EXPECT_EQ(upload().size(), 1U);
    command(NmtCommand::start);
    EXPECT_EQ(upload().size(), 1U);
    command(NmtCommand::stop);
    EXPECT_TRUE(upload().empty());
    command(NmtCommand::enter_pre_operational);
    EXPECT_TRUE(port_.take().empty());  // and nothing comes late
}

TEST_F(SlaveTest, drops_a_waiting_answer_when_stopped) {
    boot_up();
    port_.room = 0;
    upload();
    EXPECT_TRUE(slave_.pending());
    command(NmtCommand::stop);
    port_.room = RecordingPort::unlimited;
    slave_.poll(1);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(SlaveTest, exchanges_pdos_in_operational_only) {
    boot_up();
    const frame::Frame rpdo = make_frame(0x205, {1, 2, 3, 4});
    for (const NmtCommand away : {NmtCommand::enter_pre_operational, NmtCommand::stop}) {
        command(away);
        slave_.request(0);
        slave_.request_if_changed(0);
        EXPECT_EQ(slave_.receive(rpdo, now_).kind, Kind::none);
        slave_.poll(1);
        EXPECT_TRUE(port_.sent.empty());
    }
    command(NmtCommand::start);
    EXPECT_EQ(slave_.receive(rpdo, now_).kind, Kind::pdo_received);
    slave_.request(0);
    slave_.poll(2);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x185, {1, 2, 3, 4})}));
}

TEST_F(SlaveTest, drops_a_waiting_pdo_when_leaving_operational) {
    boot_up();
    command(NmtCommand::start);
    port_.room = 0;
    slave_.request(0);
    slave_.poll(1);
    EXPECT_TRUE(slave_.pending());
    command(NmtCommand::enter_pre_operational);
    EXPECT_FALSE(slave_.pending());
}

TEST_F(SlaveTest, lets_nothing_overtake_the_boot_up) {
    port_.room = 0;
    slave_.boot_up();
    slave_.poll(0);
    upload();
    command(NmtCommand::start);
    slave_.request(0);
    slave_.poll(1);
    port_.room = RecordingPort::unlimited;
    slave_.poll(2);
    const std::vector<frame::Frame> sent = port_.take();
    ASSERT_EQ(sent.size(), 3U);
    EXPECT_EQ(sent[0], make_frame(0x705, {0x00}));
    EXPECT_EQ(sent[1].id, 0x585U);
    EXPECT_EQ(sent[2].id, 0x185U);
    EXPECT_FALSE(slave_.pending());
}

}  // namespace
}  // namespace cgw::canopen
