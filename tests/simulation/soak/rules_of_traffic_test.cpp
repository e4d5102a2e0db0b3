// States, and what the gateway sends in them.
#include "simulation/soak/rules_test.hpp"

namespace cgw::simulation::soak {
namespace {

TEST_F(SoakRules, accept_a_sound_log) {
    for (int i = 0; i < 100; ++i) {
        const device::GovernorData data = deliver(i % 2 == 0);
        for (const std::size_t number : {1U, 2U, 3U, 4U, 5U, 6U}) {
            offer(tpdo(number, data));
        }
        offer(life_sign(0x05));
        offer(sdo_answer());
        rules_.carry(rpdo2(static_cast<std::uint16_t>(i)), now_);
        rules_.forward(2,
                       {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(i + 1),
                        static_cast<std::uint16_t>(i + 2), 0},
                       now_);
    }
    rules_.settle(sound());
    rules_.expect_all_carried(now_);
    EXPECT_EQ(rules_.pdos(), 603U);
    EXPECT_EQ(rules_.forwarded(), 100U);
}

TEST_F(SoakRules, see_an_illegal_transition) {
    state(GatewayState::undefined);
    state(GatewayState::operational);
    expect_broken("transition");
    offer(boot_up());
}

TEST_F(SoakRules, see_a_change_of_state_that_nobody_commanded) {
    pass(cycle);
    begin(GatewayState::stopped);
    look();
    expect_broken("transition");
}

TEST_F(SoakRules, see_a_command_that_leads_to_another_state) {
    pass(cycle);
    command(canopen::NmtCommand::stop);
    begin(GatewayState::pre_operational);
    look();
    expect_broken("transition");
}

TEST_F(SoakRules, accept_the_states_that_errors_force) {
    rules_.allow({12423, 12424});
    pass(cycle);
    begin(GatewayState::pre_operational);
    look();
    begin(GatewayState::stopped);
    look();
}

TEST_F(SoakRules, see_a_tpdo_outside_operational) {
    state(GatewayState::pre_operational);
    offer(tpdo(4, deliver()));
    expect_broken("tpdo-outside-operational");
}

TEST_F(SoakRules, see_an_rpdo_taken_outside_operational) {
    state(GatewayState::stopped);
    pass(cycle);
    ++look_.pdos_received;
    look();
    expect_broken("rpdo-outside-operational");
}

TEST_F(SoakRules, see_a_word_of_another_cycle_in_each_analogue_tpdo) {
    for (const std::size_t number : {4U, 5U, 6U}) {
        for (std::size_t word = 0; word < image_.pdo(number - 1).word_count; ++word) {
            Rules rules(image_);
            device::GovernorData before;
            device::GovernorData now;
            rules.mark(before, false);
            rules.mark(now, false);
            device::PdoWords& words = now.analogue[number - device::first_analogue_tpdo];
            words[word] = before.analogue[number - device::first_analogue_tpdo][word];
            rules.offer(tpdo(number, now), true, {now_, GatewayState::operational, true});
            ASSERT_FALSE(rules.broken().empty()) << "TPDO" << number << " word " << word + 1;
            EXPECT_EQ(rules.broken()[0].find("word-torn at "), 0U);
        }
    }
}

TEST_F(SoakRules, see_error_words_of_two_cycles) {
    device::GovernorData data = deliver(true);
    data.errors[3] = deliver(true).errors[3];
    offer(tpdo(1, data));
    expect_broken("word-torn");
}

TEST_F(SoakRules, see_words_older_than_those_before) {
    const device::GovernorData before = deliver();
    offer(tpdo(4, deliver()));
    offer(tpdo(5, before));
    expect_broken("word-old");
}

TEST_F(SoakRules, see_a_change_that_is_never_sent) {
    pass(2 * Rules::binary_patience);
    EXPECT_TRUE(rules_.broken().empty());
    look_.binary[3] = 1;
    look();
    pass(2 * Rules::binary_patience);
    expect_broken("tpdo-stale");
}

TEST_F(SoakRules, see_a_pdo_of_the_wrong_length) {
    frame::Frame frame = tpdo(2, {});
    frame.length = 3;
    offer(frame);
    expect_broken("length");
}

TEST_F(SoakRules, see_a_refused_frame_that_is_forgotten) {
    offer(tpdo(5, deliver()), false);
    pass(Rules::patience / 2);
    offer(tpdo(4, deliver()));
    pass(Rules::patience);
    expect_broken("pending-lost");
}

TEST_F(SoakRules, see_a_refused_answer_that_is_forgotten) {
    state(GatewayState::pre_operational);
    offer(sdo_answer(), false);
    pass(2 * Rules::patience);
    expect_broken("pending-lost");
}

TEST_F(SoakRules, wait_as_long_as_the_port_is_full) {
    const device::GovernorData data = deliver();
    for (Time waited = 0; waited < second; waited += cycle) {
        offer(tpdo(4, data), false);
        offer(tpdo(5, data), false);
        pass(cycle);
    }
    offer(tpdo(4, data));
    offer(tpdo(5, data));
    pass(second);
}

TEST_F(SoakRules, forgive_what_waits_when_operational_is_left) {
    offer(tpdo(5, deliver()), false);
    state(GatewayState::pre_operational);
    pass(second);
}

TEST_F(SoakRules, see_a_missing_boot_up) {
    state(GatewayState::init);
    state(GatewayState::pre_operational);
    pass(2 * Rules::patience);
    expect_broken("boot-up-missing");
}

TEST_F(SoakRules, see_a_boot_up_without_initialisation) {
    offer(boot_up());
    expect_broken("boot-up-twice");
}

TEST_F(SoakRules, see_an_identifier_that_is_not_the_gateways) {
    frame::Frame frame = sdo_answer();
    frame.id = 0x481;
    offer(frame);
    expect_broken("stray-frame");
}

TEST_F(SoakRules, see_a_tpdo_that_is_not_active) {
    std::size_t position = 0;
    while (position < facts::tpdo_count && image_.pdo(position).active) {
        ++position;
    }
    ASSERT_LT(position, facts::tpdo_count);
    frame::Frame frame;
    frame.id = image_.pdo(position).cob_id;
    offer(frame);
    expect_broken("stray-frame");
}

TEST_F(SoakRules, see_an_extended_frame_with_a_tpdos_identifier) {
    frame::Frame frame = tpdo(4, deliver());
    frame.extended = true;
    offer(frame);
    expect_broken("stray-frame");
}

TEST_F(SoakRules, see_an_answer_in_stopped) {
    state(GatewayState::stopped);
    offer(sdo_answer());
    expect_broken("answer-outside-its-states");
}

TEST_F(SoakRules, see_what_overtakes_the_boot_up) {
    state(GatewayState::init);
    state(GatewayState::pre_operational);
    offer(sdo_answer());
    offer(boot_up());
    expect_broken("boot-up-overtaken");
}

TEST_F(SoakRules, see_a_heartbeat_that_tells_another_state) {
    offer(life_sign(0x7F));
    expect_broken("heartbeat");
}

}  // namespace
}  // namespace cgw::simulation::soak
