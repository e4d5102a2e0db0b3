// What the gateway does about errors: manual 9.4, 9.5, D45, D46, D58.
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::make_frame;

class GatewayFaults : public test::GatewayTest {
  protected:
    void report(Fault fault, bool present = true) { gateway_.report(fault, present, now_); }
    void initialise() {
        command(GovernorCommand::init);
        command(GovernorCommand::pre_operational);
    }
};

TEST_F(GatewayFaults, falls_back_to_undefined_and_stays_deaf_while_can1_is_broken) {
    for (const Fault fault :
         {Fault::can1_bus, Fault::governor_can_bus, Fault::governor_can_comm, Fault::node_number_twice}) {
        start();
        report(fault);
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
        nmt(NmtCommand::start);
        initialise();
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
        EXPECT_TRUE(port_.take().empty());
        report(fault, false);
        initialise();
        EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
        EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x00})}));
    }
}

TEST_F(GatewayFaults, keeps_the_error_through_the_initialisation_until_operational) {
    start();
    report(Fault::can1_overflow);
    report(Fault::can1_overflow, false);
    initialise();
    port_.take();
    EXPECT_EQ(upload(0x2005, 0), 1U << 11);
    EXPECT_EQ(upload(0x2000, 5), 1U << 10 | 1U << 7);  // 3074 and 3071
    EXPECT_EQ(upload(0x1001, 0), 0x11U);
    nmt(NmtCommand::start);
    EXPECT_EQ(port_.take()[1], make_frame(0x285, {0, 0, 0, 0}));
    EXPECT_EQ(upload(0x2005, 0), 0U);
    EXPECT_EQ(upload(0x1001, 0), 0x00U);
}

TEST_F(GatewayFaults, drops_the_error_when_errors_are_cleared) {
    start();
    report(Fault::gateway_reset);
    report(Fault::gateway_reset, false);
    EXPECT_EQ(upload(0x2005, 0), 1U << 8);
    gateway_.clear_errors(now_);
    EXPECT_EQ(upload(0x2005, 0), 0U);
    EXPECT_EQ(link_.status.canopen_errors, 0);
}

TEST_F(GatewayFaults, goes_to_undefined_only_once_for_a_cause_that_stays) {
    start();
    report(Fault::governor_can_bus);
    report(Fault::governor_can_bus);
    EXPECT_EQ(link_.states, (std::vector{GatewayState::undefined}));
}

TEST_F(GatewayFaults, misses_a_silent_governor_after_half_a_second) {
    start();
    run_until(2'000'000);  // beyond 400
    gateway_.poll(now_ + Gateway::governor_silence - 1);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    gateway_.poll(now_ + Gateway::governor_silence);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 1U << 11);
    now_ += 1'000'000;
    initialise();
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

TEST_F(GatewayFaults, waits_for_the_governor_after_a_reset_as_long_as_400_says) {
    ASSERT_EQ(open(), OpenStatus::ok);  // 400: 1500 ms
    EXPECT_EQ(gateway_.poll(0), 2'000'000U);
    gateway_.poll(1'999'999);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 0);
    gateway_.poll(2'000'000);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 1U << 11);
}

TEST_F(GatewayFaults, goes_to_pre_operational_while_can2_is_broken_and_no_further) {
    start();
    report(Fault::can2_bus);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(upload(0x2005, 0), 1U << 12);
    report(Fault::can2_bus, false);
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
}

TEST_F(GatewayFaults, announces_itself_every_half_second_while_can2_is_broken) {
    start();
    report(Fault::can2_bus);
    // The announcements, and no other heartbeat between them: 1008 ms from the last one.
    EXPECT_EQ(run_until(1'600'000), (std::vector(4, make_frame(0x705, {0x7F}))));
    report(Fault::can2_bus, false);  // 3072 stays until errors are cleared
    EXPECT_EQ(run_until(2'100'000), (std::vector(1, make_frame(0x705, {0x7F}))));
    gateway_.clear_errors(now_);
    EXPECT_EQ(run_until(2'900'000).size(), 0U);
}

TEST_F(GatewayFaults, announces_itself_with_boot_ups_where_it_has_no_heartbeat) {
    plant_.configuration.heartbeat_producer = {};
    start();
    report(Fault::can2_bus);
    EXPECT_EQ(run_until(1'100'000), (std::vector(3, make_frame(0x705, {0x00}))));
}

TEST_F(GatewayFaults, announces_itself_in_stopped_too) {
    start();
    nmt(NmtCommand::stop);
    report(Fault::can2_bus);
    nmt(NmtCommand::stop);
    EXPECT_EQ(gateway_.state(), GatewayState::stopped);
    EXPECT_EQ(run_until(now_ + 600'000), (std::vector(2, make_frame(0x705, {0x04}))));
}

TEST_F(GatewayFaults, aborts_pdo_communication_at_once_when_the_governor_was_reset) {
    start();
    report(Fault::governor_reset);
    report(Fault::governor_reset, false);
    EXPECT_TRUE(cycle().empty());
    nmt(NmtCommand::stop);
    nmt(NmtCommand::start);
    EXPECT_TRUE(cycle().empty());
    EXPECT_EQ(gateway_.errors().canopen_errors(), 1U << 0);
    initialise();
    port_.take();
    EXPECT_EQ(upload(0x2005, 0), 1U << 0);
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 0);
}

TEST_F(GatewayFaults, misses_nobody_within_the_start_up_delay) {
    start();  // 400 is 1500 ms
    now_ = 1'400'000;
    gateway_.poll(now_);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    now_ = 1'999'999;
    gateway_.poll(now_);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    now_ = 2'000'000;
    gateway_.poll(now_);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 1U << 11);
}

TEST_F(GatewayFaults, keeps_its_sentinels_through_resets_also_of_a_refused_image) {
    std::array<std::uint8_t, GatewayErrors::error_count> before{};
    before[3072 - 3070] = 7;
    gateway_.restore(before);
    start();
    report(Fault::can2_bus);
    plant_.dictionary.objects.pop_back();  // 2005h
    EXPECT_EQ(open(), OpenStatus::object_missing);
    EXPECT_EQ(gateway_.errors().sentinels()[3072 - 3070], 8);
    EXPECT_EQ(gateway_.errors().sentinels()[3090 - 3070], 1);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 0);
}

TEST_F(GatewayFaults, tells_the_governor_of_each_refused_image) {
    plant_.dictionary.objects.pop_back();  // 2005h
    for (int i = 0; i < 2; ++i) {
        link_.status = {};
        EXPECT_EQ(open(), OpenStatus::object_missing);
        EXPECT_EQ(link_.status.errors[5], 1U << 10);  // 3090
    }
}

TEST_F(GatewayFaults, announces_itself_on_a_bus_that_is_back_until_3072_is_cleared) {
    plant_.configuration.heartbeat_producer = {};
    start();
    report(Fault::can2_bus);
    report(Fault::can2_bus, false);
    port_.take();
    EXPECT_EQ(run_until(now_ + 1'100'000), (std::vector(3, make_frame(0x705, {0x00}))));
}

TEST_F(GatewayFaults, announces_itself_no_more_once_it_is_operational_again) {
    plant_.configuration.heartbeat_producer = {};
    start();
    report(Fault::can2_bus);
    port_.take();
    port_.room = 0;
    run_until(now_ + 600'000);
    report(Fault::can2_bus, false);
    port_.room = test::RecordingPort::unlimited;
    nmt(NmtCommand::start);
    for (const frame::Frame& frame : run_until(now_ + 600'000)) {
        EXPECT_NE(frame.id, 0x705U);
    }
}

TEST_F(GatewayFaults, does_not_answer_late_what_was_asked_before_can2_broke) {
    start();
    port_.room = 0;
    gateway_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), now_);
    report(Fault::can2_bus);
    report(Fault::can2_bus, false);
    port_.room = test::RecordingPort::unlimited;
    for (const frame::Frame& frame : cycle()) {
        EXPECT_NE(frame.id, 0x585U);
    }
}

TEST_F(GatewayFaults, does_not_announce_itself_before_it_is_initialised) {
    ASSERT_EQ(open(), OpenStatus::ok);
    report(Fault::can2_bus);
    EXPECT_TRUE(run_until(2'000'000).empty());
    initialise();
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x00})}));
}

TEST_F(GatewayFaults, initialises_anew_after_an_overflow_of_the_canopen_reception) {
    start();
    report(Fault::can2_receive_overflow);
    report(Fault::can2_receive_overflow, false);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    initialise();
    port_.take();
    EXPECT_EQ(upload(0x2005, 0), 1U << 13);
}

TEST_F(GatewayFaults, stops_when_sdo_answers_find_no_room) {
    start();
    port_.room = 0;
    for (std::size_t i = 0; i <= canopen::SdoServer::capacity; ++i) {
        gateway_.receive(make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), now_);
    }
    EXPECT_EQ(gateway_.state(), GatewayState::stopped);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 1U << 13);
    port_.room = test::RecordingPort::unlimited;
    EXPECT_TRUE(cycle().empty());  // its buffer is cleared
    nmt(NmtCommand::start);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    EXPECT_EQ(gateway_.errors().canopen_errors(), 0);
}

TEST_F(GatewayFaults, stays_undefined_after_an_error_that_only_a_reset_clears) {
    for (const Fault fault : {Fault::parameter_store, Fault::program_memory, Fault::working_memory,
                              Fault::data, Fault::stack, Fault::internal}) {
        start();
        report(fault);
        report(fault, false);
        gateway_.clear_errors(now_);
        initialise();
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    }
}

TEST_F(GatewayFaults, goes_on_while_the_supply_is_low) {
    start();
    report(Fault::supply_voltage);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    EXPECT_EQ(upload(0x2000, 6), 1U << 5);  // 3085
    report(Fault::supply_voltage, false);
    EXPECT_EQ(upload(0x2000, 6), 0U);
}

TEST_F(GatewayFaults, joins_its_errors_with_the_governors) {
    start();
    data_.errors[5] = 0x0001;
    report(Fault::supply_voltage);
    cycle();
    EXPECT_EQ(upload(0x2000, 6), 1U << 5 | 1U);
}

TEST_F(GatewayFaults, shows_3090_when_the_image_asks_for_too_much) {
    plant_.dictionary.objects.pop_back();  // 2005h
    EXPECT_EQ(open(), OpenStatus::object_missing);
    EXPECT_TRUE(gateway_.errors().shown(Fault::data));
    initialise();
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(gateway_.poll(10'000'000), canopen::never);
}

}  // namespace
}  // namespace cgw::device
