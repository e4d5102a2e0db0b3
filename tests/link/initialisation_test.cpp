// From a reset to Pre-Operational, and what stands in the way (manual chapter 3 and 9.5, D56).
#include "link_test.hpp"

namespace cgw::link {
namespace {

using device::GatewayState;
using Phase = GovernorEnd::Phase;

constexpr std::uint16_t governor_reset = 1U << 0;  // 12411 in 2005h
constexpr std::uint16_t initialisation = 1U << 1;  // 12412
constexpr std::uint16_t gateway_reset = 1U << 8;   // 12419

using Initialisation = test::LinkTest;

TEST_F(Initialisation, brings_the_gateway_to_pre_operational_with_one_boot_up) {
    run_for(300'000);
    EXPECT_EQ(governor_end_.phase(), Phase::running);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(can2_.take(), (std::vector{test::make_frame(0x705, {0x00})}));
    EXPECT_EQ(status_.state, GatewayState::pre_operational);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Initialisation, needs_no_more_than_a_quarter_of_a_second) {
    run_for(250'000);
    EXPECT_EQ(governor_end_.phase(), Phase::running);
}

TEST_F(Initialisation, is_given_up_after_three_attempts_when_the_configurations_differ) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(5).mapping[0].parameter = &plant.speed; });
    run_for(5'000'000);
    EXPECT_EQ(governor_end_.phase(), Phase::given_up);
    EXPECT_EQ(governor_end_.failed_attempts(), 3U);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), initialisation);
    EXPECT_EQ(status_.canopen_errors, initialisation);
    EXPECT_TRUE(can2_.sent.empty());
}

TEST_F(Initialisation, says_what_differs) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(5).mapping[0].parameter = &plant.speed; });
    run_for(2'000'000);
    const Refusal& refusal = gateway_end_.refusal();
    EXPECT_FALSE(refusal.incomplete);
    EXPECT_EQ(refusal.expected.kind, ItemKind::assignment);
    EXPECT_EQ(refusal.expected.position, 4);  // TPDO5, first word
    EXPECT_EQ(refusal.expected.value, 2905);
    EXPECT_EQ(refusal.received, 2000);
    const RefusalReport& report = governor_end_.refusal();
    EXPECT_EQ(report.item_kind, static_cast<std::uint8_t>(ItemKind::assignment));
    EXPECT_EQ(report.position, 4);
    EXPECT_EQ(report.governor_value, 2000);
    EXPECT_EQ(report.gateway_value, 2905);
}

TEST_F(Initialisation, notices_every_kind_of_difference) {
    const std::pair<std::function<void(test::SamplePlant&)>, ItemKind> cases[] = {
        {[](test::SamplePlant& plant) {
             plant.tpdo(4).time = {32, 2, 31'250};
         },
         ItemKind::cycles},
        {[](test::SamplePlant& plant) {
             plant.rpdo(2).time = {110, 7, 109'375};
         },
         ItemKind::monitoring},
        {[](test::SamplePlant& plant) { plant.configuration.switches.pop_back(); }, ItemKind::switches},
        {[](test::SamplePlant& plant) { plant.configuration.switches[0].bit = 2; }, ItemKind::switch_bit},
        {[](test::SamplePlant& plant) { plant.configuration.switches[0].low_active = true; },
         ItemKind::switch_bit},
        {[](test::SamplePlant& plant) { plant.setpoint.number = 901; }, ItemKind::sensor_number},
    };
    for (const auto& [change, kind] : cases) {
        test::SamplePlant other;
        other.configuration.heartbeat_consumer = {};
        change(other);
        const base::Bytes bytes = other.image();
        image::Image image;
        const image::Status status = image::Image::open(bytes, image);
        ASSERT_EQ(status, image::Status::ok) << image::to_text(status) << static_cast<int>(kind);
        now_ += 10'000'000;
        open_gateway(1);
        governor_end_.open(image, 1);
        run_for(2'000'000);
        EXPECT_EQ(governor_end_.phase(), Phase::given_up);
        EXPECT_EQ(gateway_end_.refusal().expected.kind, kind);
    }
}

TEST_F(Initialisation, is_tried_three_times_more_when_errors_are_cleared) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(4).time = {32, 2, 31'250}; });
    run_for(5'000'000);
    ASSERT_EQ(governor_end_.phase(), Phase::given_up);
    governor_end_.clear_errors();
    run_for(100'000);
    EXPECT_EQ(errors(), 0);
    run_for(5'000'000);
    EXPECT_EQ(governor_end_.phase(), Phase::given_up);
    EXPECT_EQ(errors(), initialisation);
}

TEST_F(Initialisation, succeeds_once_the_governor_has_the_right_configuration) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(4).time = {32, 2, 31'250}; });
    run_for(5'000'000);
    governor_end_.open(image_, 2);  // set up anew, and reset
    run_for(500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

TEST_F(Initialisation, is_repeated_when_telegrams_of_the_configuration_are_lost) {
    unsigned seen = 0;
    lost_ = [&seen](const frame::Frame& frame) {
        return read_telegram(frame)->kind == kind_of(Kind::configuration) && ++seen == 5;
    };
    run_for(1'000'000);
    EXPECT_TRUE(gateway_end_.refusal().incomplete);
    EXPECT_EQ(governor_end_.phase(), Phase::running);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

TEST_F(Initialisation, survives_the_loss_of_any_one_telegram) {
    data_.analogue[0] = {1, 2, 3, 4};
    for (auto* const direction : {&lost_, &lost_to_governor_}) {
        for (unsigned lost = 1; lost < 60; ++lost) {
            unsigned seen = 0;
            *direction = [&seen, lost](const frame::Frame&) { return ++seen == lost; };
            now_ += 10'000'000;
            open_gateway(1);
            governor_end_.open(image_, 1);
            run_for(2'500'000);
            EXPECT_EQ(gateway_.state(), GatewayState::pre_operational) << lost;
            EXPECT_EQ(status_.state, GatewayState::pre_operational) << lost;
            EXPECT_EQ(errors(), 0) << lost;
        }
        *direction = nullptr;
    }
    start();
    cycle();
    EXPECT_EQ(tpdo4(), test::make_frame(0x485, {1, 0, 2, 0, 3, 0, 4, 0}));
}

TEST_F(Initialisation, brings_words_that_never_change_to_a_gateway_that_joins_later) {
    data_.analogue[0] = {1, 2, 3, 4};
    data_.errors[0] = 0x1234;
    lost_ = lost_to_governor_ = [](const frame::Frame&) { return true; };
    run_for(1'000'000);
    lost_ = lost_to_governor_ = nullptr;
    open_gateway(1);
    start();
    cycle();
    EXPECT_EQ(tpdo4(), test::make_frame(0x485, {1, 0, 2, 0, 3, 0, 4, 0}));
    gateway_.receive(canopen::sdo::make_frame(0x605, 0x40, {0x2000, 1}, 0), now_);
    EXPECT_EQ(canopen::sdo::payload(can2_.take().back()), 0x1234U);
}

TEST_F(Initialisation, is_given_up_for_good_although_the_command_that_says_so_is_lost) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(4).time = {32, 2, 31'250}; });
    bool lost = false;
    lost_ = [&lost](const frame::Frame& frame) {
        const bool last = read_telegram(frame)->kind == kind_of(Kind::command) &&
                          (frame.data[2] & command::given_up) != 0 && !lost;
        lost = lost || last;
        return last;
    };
    run_for(5'000'000);
    EXPECT_TRUE(lost);
    EXPECT_EQ(governor_end_.phase(), Phase::given_up);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), initialisation);
}

TEST_F(Initialisation, is_tried_three_times_more_when_errors_are_cleared_at_the_gateway) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(4).time = {32, 2, 31'250}; });
    run_for(5'000'000);
    ASSERT_EQ(governor_end_.phase(), Phase::given_up);
    gateway_end_.clear_errors(now_);
    cycle();
    EXPECT_EQ(errors(), 0);
    EXPECT_NE(governor_end_.phase(), Phase::given_up);
    run_for(5'000'000);
    EXPECT_EQ(governor_end_.phase(), Phase::given_up);
    EXPECT_EQ(errors(), initialisation);
}

TEST_F(Initialisation, is_tried_three_times_more_after_a_reset_of_the_gateway) {
    governor_differs([](test::SamplePlant& plant) { plant.tpdo(4).time = {32, 2, 31'250}; });
    run_for(5'000'000);
    open_gateway(2);
    run_for(5'000'000);
    EXPECT_EQ(governor_end_.phase(), Phase::given_up);
    EXPECT_EQ(errors(), initialisation | gateway_reset);
}

TEST_F(Initialisation, tells_of_a_reset_of_the_gateway_although_the_first_command_is_lost) {
    start();
    open_gateway(2);
    bool lost = false;
    lost_ = [&lost](const frame::Frame& frame) {
        const bool first = read_telegram(frame)->kind == kind_of(Kind::command) && !lost;
        lost = lost || first;
        return first;
    };
    run_for(2'000'000);
    EXPECT_TRUE(lost);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(), gateway_reset);
}

TEST_F(Initialisation, goes_on_when_can1_takes_one_frame_at_a_time) {
    to_gateway_.room = 1;
    to_governor_.room = 1;
    run_for(3'000'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

TEST_F(Initialisation, begins_anew_after_a_reset_of_the_governor_alone) {
    start();
    governor_end_.open(image_, 2);
    run_for(300'000);
    EXPECT_EQ(governor_end_.failed_attempts(), 0U);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(), governor_reset);
    EXPECT_EQ(can2_.take().back(), test::make_frame(0x705, {0x00}));
    gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), now_);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Initialisation, is_begun_anew_by_a_governor_that_was_reset_in_the_middle_of_it) {
    while (governor_end_.phase() != Phase::configuring) {
        cycle();
    }
    cycle();
    governor_end_ = GovernorEnd(to_gateway_, *this);  // its sequences begin anew
    governor_end_.open(image_, 2);
    run_for(400'000);
    EXPECT_EQ(governor_end_.failed_attempts(), 0U);
    EXPECT_EQ(governor_end_.phase(), Phase::running);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

TEST_F(Initialisation, begins_anew_after_a_reset_of_the_gateway_alone) {
    start();
    open_gateway(2);
    run_for(500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(), gateway_reset);
}

TEST_F(Initialisation, begins_anew_after_a_reset_by_the_master_without_an_error) {
    start();
    gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::reset_node, 5), now_);
    EXPECT_EQ(gateway_.state(), GatewayState::init);
    run_for(500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Initialisation, does_not_begin_while_an_error_forbids_it) {
    gateway_.report(device::Fault::program_memory, true, now_);
    run_for(3'000'000);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(governor_end_.failed_attempts(), 0U);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Initialisation, ignores_telegrams_of_other_pairs) {
    for (const Address from : {Address{DeviceType::governor, 4}, Address{DeviceType::gateway, 3}}) {
        frame::Frame frame =
            make_telegram(kind_of(Kind::command), from, {DeviceType::gateway, 7}, command::length);
        frame.data[1] = static_cast<std::uint8_t>(device::GovernorCommand::init);
        gateway_end_.receive(frame, now_);
    }
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Initialisation, ignores_telegrams_that_are_too_short) {
    constexpr Address from{DeviceType::governor, 3};
    constexpr Address to{DeviceType::gateway, 7};
    for (unsigned kind = 0; kind < 256; ++kind) {
        gateway_end_.receive(make_telegram(static_cast<std::uint8_t>(kind), from, to, 0), now_);
        governor_end_.receive(make_telegram(static_cast<std::uint8_t>(kind), to, from, 0), now_);
    }
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    run_for(300'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
}

}  // namespace
}  // namespace cgw::link
