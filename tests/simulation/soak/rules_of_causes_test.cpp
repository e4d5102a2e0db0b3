// Errors and alarms with their causes, the way of frames and words, and what must come back afterwards.
#include "simulation/soak/rules_test.hpp"

namespace cgw::simulation::soak {
namespace {

TEST_F(SoakRules, see_an_error_without_cause_and_accept_one_that_has_one) {
    rules_.allow({12413});
    look_.canopen_errors = 1U << 2;
    look();
    EXPECT_TRUE(rules_.broken().empty());
    look_.canopen_errors = 1U << 9;
    look();
    expect_broken("error-without-cause");
}

TEST_F(SoakRules, see_an_error_of_2000h_without_cause_and_accept_those_that_have_one) {
    rules_.allow({12422});
    look_.canopen_errors = 1U << 11;
    look_.binary[4] = (1U << 7) | (1U << 10);  // 3071, 3074
    look_.binary[0] = 1U << 5;                 // 3005, of sensor 900
    look();
    look_.binary[2] = 0xFFFF;  // flickers
    look();
    EXPECT_TRUE(rules_.broken().empty());
    look_.binary[5] = 1U << 14;  // 3094
    look();
    expect_broken("error-without-cause");
}

TEST_F(SoakRules, see_3074_without_an_error_of_canopen) {
    look_.binary[4] = 1U << 10;
    look();
    expect_broken("error-without-cause");
}

TEST_F(SoakRules, see_an_alarm_without_cause_and_accept_one_that_has_one) {
    rules_.allow_alarms({Alarm::hot_coolant});
    look_.alarms.set(static_cast<std::size_t>(Alarm::hot_coolant));
    look();
    EXPECT_TRUE(rules_.broken().empty());
    look_.alarms.set(static_cast<std::size_t>(Alarm::overspeed));
    look();
    expect_broken("alarm-without-cause");
}

TEST_F(SoakRules, see_an_alarm_whose_cause_was_mended_before) {
    rules_.allow_alarms({Alarm::hot_coolant});
    rules_.allow_none();
    look_.alarms.set(static_cast<std::size_t>(Alarm::hot_coolant));
    look();
    expect_broken("alarm-without-cause");
}

TEST_F(SoakRules, see_a_receive_pdo_put_together_of_two) {
    rules_.carry(rpdo2(0x1000), now_);
    rules_.carry(rpdo2(0x2000), now_);
    rules_.forward(2, {0x2000, 0x1001, 0x1002, 0}, now_);
    expect_broken("rpdo-torn");
}

TEST_F(SoakRules, see_a_receive_pdo_that_comes_after_a_newer_one) {
    rules_.carry(rpdo2(0x1000), now_);
    rules_.carry(rpdo2(0x2000), now_);
    rules_.forward(2, {0x2000, 0x2001, 0x2002, 0}, now_);
    rules_.forward(2, {0x1000, 0x1001, 0x1002, 0}, now_);
    expect_broken("rpdo-torn");
}

TEST_F(SoakRules, see_a_frame_lost_between_port_and_bus_unless_the_bus_was_cut) {
    const frame::Frame frame = tpdo(4, deliver());
    rules_.offer(frame, true, {now_, GatewayState::operational, false});
    EXPECT_FALSE(rules_.all_carried());
    rules_.can2_was_cut();
    rules_.expect_all_carried(now_);
    EXPECT_TRUE(rules_.broken().empty());
    rules_.offer(frame, true, {now_, GatewayState::operational, false});
    rules_.expect_all_carried(now_);
    expect_broken("frame-lost");
}

TEST_F(SoakRules, do_not_excuse_a_lost_frame_with_a_cut_of_former_times) {
    rules_.can2_was_cut();
    rules_.expect_all_carried(now_);
    rules_.offer(tpdo(4, deliver()), true, {now_, GatewayState::operational, false});
    rules_.expect_all_carried(now_);
    expect_broken("frame-lost");
}

TEST_F(SoakRules, wait_for_a_frame_on_its_way_after_a_cut) {
    rules_.can2_was_cut();
    offer(tpdo(4, deliver()));
    const frame::Frame frame = tpdo(5, deliver());
    rules_.offer(frame, true, {now_, GatewayState::operational, false});
    EXPECT_FALSE(rules_.all_carried());
    rules_.carry(frame, now_);
    EXPECT_TRUE(rules_.all_carried());
    rules_.expect_all_carried(now_);
}

TEST_F(SoakRules, see_a_frame_that_nobody_offered) {
    rules_.carry(tpdo(4, deliver()), now_);
    rules_.expect_all_carried(now_);
    expect_broken("frame-lost");
}

// --- afterwards ---

TEST_F(SoakRules, see_a_gateway_that_does_not_come_back) {
    Settled settled = sound();
    settled.state = GatewayState::pre_operational;
    rules_.settle(settled);
    expect_broken("not-operational");
}

TEST_F(SoakRules, see_an_error_that_stays) {
    Settled settled = sound();
    settled.errors = {3005};
    rules_.settle(settled);
    expect_broken("error-stuck");
}

TEST_F(SoakRules, see_an_alarm_that_stays) {
    Settled settled = sound();
    settled.alarms = true;
    rules_.settle(settled);
    expect_broken("alarm-stuck");
}

TEST_F(SoakRules, see_an_engine_that_does_not_run_again) {
    Settled settled = sound();
    settled.engine_runs = false;
    rules_.settle(settled);
    expect_broken("alarm-stuck");
}

TEST_F(SoakRules, see_a_cyclic_tpdo_that_does_not_come) {
    pass(second);
    offer(life_sign(0x05));
    Settled settled = sound();
    settled.tpdos[5]->time = now_ - 300'000;  // TPDO6, every 200 ms
    rules_.settle(settled);
    expect_broken("tpdo-late");
}

TEST_F(SoakRules, see_a_heartbeat_that_no_longer_comes) {
    pass(second);
    rules_.settle(sound());
    expect_broken("heartbeat-late");
}

TEST_F(SoakRules, see_a_tpdo_that_comes_with_the_words_of_an_old_cycle) {
    for (int i = 0; i < 40; ++i) {
        deliver();
    }
    Settled settled = sound();
    settled.tpdos[5]->first_word = static_cast<std::uint16_t>(cycles_ - 13);  // TPDO6, every 13 cycles
    rules_.settle(settled);
    EXPECT_TRUE(rules_.broken().empty());
    settled.tpdos[5]->first_word = static_cast<std::uint16_t>(cycles_ - 20);
    rules_.settle(settled);
    expect_broken("tpdo-stale");
}

TEST_F(SoakRules, see_an_engine_state_that_was_not_sent) {
    Settled settled = sound();
    settled.engine_state = 0x1C;
    rules_.settle(settled);
    expect_broken("tpdo-stale");
}

TEST_F(SoakRules, see_words_of_the_plc_that_did_not_arrive) {
    Settled settled = sound();
    settled.obeyed[1] = 0;
    rules_.settle(settled);
    expect_broken("rpdo-lost");
}

}  // namespace
}  // namespace cgw::simulation::soak
