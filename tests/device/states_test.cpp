// The five-state machine and its two sources of commands (D50).
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::make_frame;
using States = std::vector<GatewayState>;

class GatewayStates : public test::GatewayTest {};

TEST_F(GatewayStates, does_nothing_before_it_has_an_image) {
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    nmt(NmtCommand::start);
    cycle();
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_TRUE(port_.sent.empty());
    EXPECT_TRUE(link_.states.empty());
}

TEST_F(GatewayStates, starts_undefined_and_silent) {
    ASSERT_EQ(open(), OpenStatus::ok);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(gateway_.poll(10'000'000), canopen::never);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(GatewayStates, sends_one_boot_up_when_the_governor_ends_the_initialisation) {
    ASSERT_EQ(open(), OpenStatus::ok);
    command(GovernorCommand::init);
    EXPECT_EQ(gateway_.state(), GatewayState::init);
    EXPECT_TRUE(port_.sent.empty());
    command(GovernorCommand::pre_operational);
    command(GovernorCommand::pre_operational);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x00})}));
    EXPECT_EQ(link_.states, (States{GatewayState::init, GatewayState::pre_operational}));
}

TEST_F(GatewayStates, takes_pre_operational_from_the_governor_in_init_only) {
    ASSERT_EQ(open(), OpenStatus::ok);
    command(GovernorCommand::pre_operational);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    start();
    command(GovernorCommand::pre_operational);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    nmt(NmtCommand::stop);
    command(GovernorCommand::pre_operational);
    EXPECT_EQ(gateway_.state(), GatewayState::stopped);
    EXPECT_TRUE(port_.take().empty());
}

TEST_F(GatewayStates, ignores_nmt_in_undefined_and_init) {
    ASSERT_EQ(open(), OpenStatus::ok);
    for (const NmtCommand any : {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                                 NmtCommand::reset_node, NmtCommand::reset_communication}) {
        nmt(any);
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    }
    command(GovernorCommand::init);
    nmt(NmtCommand::start);
    nmt(NmtCommand::reset_node);
    EXPECT_EQ(gateway_.state(), GatewayState::init);
    EXPECT_EQ(link_.states, (States{GatewayState::init}));
}

TEST_F(GatewayStates, obeys_nmt_in_the_three_communicating_states) {
    boot_up();
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    nmt(NmtCommand::stop);
    EXPECT_EQ(gateway_.state(), GatewayState::stopped);
    nmt(NmtCommand::enter_pre_operational);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    nmt(NmtCommand::start, canopen::all_nodes);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    EXPECT_EQ(link_.states, (States{GatewayState::operational, GatewayState::stopped,
                                    GatewayState::pre_operational, GatewayState::operational}));
}

TEST_F(GatewayStates, ignores_nmt_for_others_of_wrong_length_and_unknown) {
    boot_up();
    nmt(NmtCommand::start, 6);
    gateway_.receive(make_frame(0, {0x01}), now_);
    gateway_.receive(make_frame(0, {0x01, 5, 0}), now_);
    gateway_.receive(make_frame(0, {0x03, 5}), now_);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_TRUE(link_.states.empty());
}

TEST_F(GatewayStates, goes_to_init_on_both_resets_and_boots_once_when_the_governor_is_done) {
    start();
    for (const NmtCommand reset : {NmtCommand::reset_node, NmtCommand::reset_communication}) {
        nmt(reset);
        EXPECT_EQ(gateway_.state(), GatewayState::init);
        EXPECT_TRUE(port_.take().empty());
        EXPECT_TRUE(cycle().empty());
        command(GovernorCommand::init);
        command(GovernorCommand::pre_operational);
        EXPECT_EQ(run_until(now_ + 10 * main_cycle), (std::vector{make_frame(0x705, {0x00})}));
        EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    }
    EXPECT_EQ(link_.states, (States{GatewayState::init, GatewayState::pre_operational, GatewayState::init,
                                    GatewayState::pre_operational}));
}

TEST_F(GatewayStates, boots_exactly_once_after_resets_that_follow_each_other) {
    start();
    nmt(NmtCommand::reset_communication);
    nmt(NmtCommand::reset_node);
    std::vector<frame::Frame> sent = cycle();
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    gateway_.poll(now_);
    const std::vector<frame::Frame> later = cycle();
    sent.insert(sent.end(), later.begin(), later.end());
    EXPECT_EQ(sent, (std::vector{make_frame(0x705, {0x00})}));
}

TEST_F(GatewayStates, falls_silent_in_every_state_when_the_governor_says_undefined) {
    const NmtCommand ways[] = {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                               NmtCommand::reset_node};
    for (const NmtCommand way : ways) {
        start();
        nmt(way);
        port_.take();
        command(GovernorCommand::undefined);
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
        nmt(NmtCommand::start);
        gateway_.receive(canopen::sdo::make_frame(0x605, 0x40, {0x1000, 0}, 0), now_);
        EXPECT_TRUE(cycle().empty());
        EXPECT_EQ(gateway_.poll(now_ + 10'000'000), canopen::never);
        EXPECT_TRUE(port_.take().empty());
        EXPECT_EQ(link_.states.back(), GatewayState::undefined);
    }
}

TEST_F(GatewayStates, shows_its_state_in_the_heartbeat_one_period_after_boot_up) {
    boot_up();
    EXPECT_TRUE(run_until(1'000'000).empty());
    nmt(NmtCommand::stop);
    EXPECT_EQ(run_until(1'020'000), (std::vector{make_frame(0x705, {0x04})}));
    nmt(NmtCommand::enter_pre_operational);
    EXPECT_EQ(run_until(2'030'000), (std::vector{make_frame(0x705, {0x7F})}));
    nmt(NmtCommand::start);
    std::vector<frame::Frame> heartbeats = run_until(3'040'000);
    std::erase_if(heartbeats, [](const frame::Frame& frame) { return frame.id != 0x705; });
    EXPECT_EQ(heartbeats, (std::vector{make_frame(0x705, {0x05})}));
}

TEST_F(GatewayStates, sends_no_heartbeat_when_its_time_is_zero) {
    plant_.configuration.heartbeat_producer = {};
    boot_up();
    EXPECT_TRUE(run_until(100'000'000).empty());
}

}  // namespace
}  // namespace cgw::device
