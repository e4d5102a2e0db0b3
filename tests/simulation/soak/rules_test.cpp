// A soak whose rules cannot be broken proves nothing: each rule is broken here once, in a log that is sound
// but for that.
#include "simulation/soak/rules.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "canopen/nmt.hpp"
#include "simulation/soak/world.hpp"
#include "wire/little_endian.hpp"

namespace cgw::simulation::soak {
namespace {

constexpr Time cycle = 15'625;

class SoakRules : public testing::Test {
  protected:
    // A gateway that has been initialised and started.
    SoakRules() {
        state(GatewayState::undefined);
        state(GatewayState::init);
        pass(cycle);
        begin(GatewayState::pre_operational);
        offer(boot_up());
        look();
        look_.binary[6] = 4;  // as tpdo() says
        state(GatewayState::operational);
        for (std::size_t number = 1; number <= facts::binary_tpdos; ++number) {
            offer(tpdo(number, {}));
        }
    }

    void TearDown() override {
        EXPECT_EQ(fmt::format("{}", fmt::join(rules_.broken(), "\n")).substr(0, expected_.size()), expected_);
        EXPECT_EQ(rules_.broken().size(), expected_.empty() ? 0U : 1U);
    }
    // The one rule that the test breaks.
    void expect_broken(const std::string& rule) { expected_ = rule + " at "; }

    void begin(GatewayState state) { look_.state = state; }
    void look() {
        look_.now = now_;
        rules_.look(look_);
    }
    void command(canopen::NmtCommand command) {
        rules_.carry(canopen::nmt_frame(command, image_.can2().own_node), now_);
    }
    // Enters it, commanded where a command leads there.
    void state(GatewayState state) {
        if (state == GatewayState::operational) {
            command(canopen::NmtCommand::start);
        } else if (state == GatewayState::stopped) {
            command(canopen::NmtCommand::stop);
        } else if (state == GatewayState::pre_operational) {
            command(canopen::NmtCommand::enter_pre_operational);
        }
        begin(state);
        look();
    }
    void pass(Time time) {
        for (Time passed = 0; passed < time; passed += 1'000) {
            now_ += 1'000;
            look();
        }
    }
    void offer(const frame::Frame& frame, bool taken = true) {
        rules_.offer(frame, taken, {now_, look_.state, false});
        if (taken) {
            rules_.carry(frame, now_);
        }
    }

    frame::Frame life_sign(std::uint8_t value) const {
        frame::Frame frame;
        frame.id = canopen::cob::heartbeat + image_.can2().own_node;
        frame.length = 1;
        frame.data[0] = value;
        return frame;
    }
    frame::Frame boot_up() const { return life_sign(0); }
    frame::Frame sdo_answer() const {
        frame::Frame frame;
        frame.id = canopen::cob::sdo_answer + image_.can2().own_node;
        frame.length = 8;
        return frame;
    }
    // TPDO number 1..16 with the words of these data.
    frame::Frame tpdo(std::size_t number, const device::GovernorData& data) const {
        const image::Pdo pdo = image_.pdo(number - 1);
        frame::Frame frame;
        frame.id = pdo.cob_id;
        frame.length = static_cast<std::uint8_t>(2 * pdo.word_count);
        for (std::size_t word = 0; word < pdo.word_count; ++word) {
            const std::uint16_t value = number >= device::first_analogue_tpdo
                                            ? data.analogue[number - device::first_analogue_tpdo][word]
                                            : data.errors[word];
            wire::store_u16(&frame.data[2 * word], number == 3 ? std::uint16_t{4} : value);
        }
        return frame;
    }
    device::GovernorData deliver(bool flicker = false) {
        now_ += cycle;
        ++cycles_;
        device::GovernorData data;
        rules_.mark(data, flicker);
        std::copy(data.errors.begin(), data.errors.end(), look_.binary.begin());
        look();
        return data;
    }
    // RPDO2 of the genset has three words.
    frame::Frame rpdo2(std::uint16_t first) const {
        frame::Frame frame;
        frame.id = image_.pdo(facts::tpdo_count + 1U).cob_id;
        frame.length = 6;
        for (std::size_t word = 0; word < 3; ++word) {
            wire::store_u16(&frame.data[2 * word], static_cast<std::uint16_t>(first + word));
        }
        return frame;
    }
    Settled sound() const {
        Settled settled;
        settled.now = now_;
        for (std::size_t position = 0; position < facts::tpdo_count; ++position) {
            settled.tpdos[position] = {now_, position < facts::binary_tpdos ? std::uint16_t{4} : cycles_};
        }
        settled.engine_state = 4;
        settled.sent = settled.obeyed = {1, 2, 3};
        return settled;
    }

    const image::Image& image_ = fast_genset();
    Rules rules_{image_};
    Look look_;
    Time now_ = 1'000'000;
    std::uint16_t cycles_ = 0;  // of the governor
    std::string expected_;
};

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
