// What travels once the gateway is initialised.
#include "link_test.hpp"

namespace cgw::link {
namespace {

using device::GatewayState;
using test::make_frame;

using Exchange = test::LinkTest;

constexpr std::uint32_t tpdo5_id = 0x282;

TEST_F(Exchange, brings_the_governors_words_to_the_transmit_pdos) {
    data_.analogue[0] = {0x1122, 0x3344, 0x5566, 0x7788};
    data_.errors = {1, 2, 3, 4, 5, 6};
    start();
    cycle();
    const std::vector<frame::Frame> sent = can2_.take();
    EXPECT_EQ(sent[0], make_frame(0x485, {0x22, 0x11, 0x44, 0x33, 0x66, 0x55, 0x88, 0x77}));
    for (std::uint8_t word = 0; word < 6; ++word) {
        gateway_.receive(
            canopen::sdo::make_frame(0x605, 0x40, {0x2000, static_cast<std::uint8_t>(word + 1)}, 0), now_);
        EXPECT_EQ(canopen::sdo::payload(can2_.take().back()), word + 1U);
    }
}

TEST_F(Exchange, sends_words_again_only_when_they_change) {
    start();
    cycle();
    std::size_t analogue = 0;
    lost_ = [&analogue](const frame::Frame& frame) {
        const unsigned kind = read_telegram(frame)->kind;
        analogue += kind >= kind_of(Kind::analogue, 4) && kind <= kind_of(Kind::analogue, 16) ? 1U : 0U;
        return false;
    };
    run_for(500'000);
    EXPECT_EQ(analogue, 0U);
    data_.analogue[3][2] = 7;
    run_for(500'000);
    EXPECT_EQ(analogue, 1U);
}

TEST_F(Exchange, brings_receive_pdos_to_the_governor) {
    start();
    gateway_.receive(make_frame(0x305, {0x34, 0x12}), now_);
    cycle();
    ASSERT_EQ(received_.size(), 1U);
    EXPECT_EQ(received_[0], (std::pair<std::uint8_t, device::PdoWords>{2, {0x1234, 0, 0, 0}}));
}

TEST_F(Exchange, keeps_the_newest_receive_pdo_while_can1_takes_nothing) {
    start();
    to_governor_.room = 0;
    for (std::uint8_t value = 1; value <= 3; ++value) {
        gateway_.receive(make_frame(0x305, {value, 0}), now_);
    }
    to_governor_.room = 64;
    cycle();
    ASSERT_EQ(received_.size(), 1U);
    EXPECT_EQ(received_[0].second[0], 3);
}

TEST_F(Exchange, tells_the_governor_state_and_errors) {
    start();
    gateway_.report(device::Fault::supply_voltage, true, now_);
    cycle();
    EXPECT_EQ(status_.state, GatewayState::operational);
    EXPECT_EQ(status_.errors[5], 1U << 5);  // 3085
    EXPECT_EQ(status_, gateway_.status());
}

TEST_F(Exchange, tells_the_gateway_the_governors_own_can_errors) {
    start();
    flags_ = cycle::can_comm_error;
    LinkTest::cycle();
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), 1U << 4);  // 12415
    flags_ = 0;
    run_for(1'500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(errors(), 1U << 4);  // until errors are cleared, or Operational
    governor_end_.clear_errors();
    run_for(100'000);
    EXPECT_EQ(errors(), 0);
}

TEST_F(Exchange, finds_the_gateway_again_after_silence) {
    data_.analogue[0] = {1, 2, 3, 4};
    start();
    run_for(2'000'000);  // beyond 400, within which nobody is missed
    lost_ = [](const frame::Frame&) { return true; };
    run_for(1'000'000);
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), 1U << 11);  // 12422
    lost_ = nullptr;
    run_for(1'500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    start();
    cycle();
    EXPECT_EQ(tpdo4(), make_frame(0x485, {1, 0, 2, 0, 3, 0, 4, 0}));
}

TEST_F(Exchange, forgets_what_a_gateway_said_that_falls_silent) {
    start();
    ASSERT_EQ(status_.state, GatewayState::operational);
    lost_to_governor_ = [](const frame::Frame&) { return true; };
    run_for(600'000);
    EXPECT_EQ(status_, device::GatewayStatus{});
    EXPECT_EQ(gateway_.state(), GatewayState::undefined);
    EXPECT_EQ(errors(), 1U << 4);  // 12415: the governor does not hear it
    lost_to_governor_ = nullptr;
    run_for(1'500'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    EXPECT_EQ(status_.state, GatewayState::pre_operational);
}

TEST_F(Exchange, stays_undefined_while_another_device_has_its_number) {
    start();
    const frame::Frame foreign =
        make_telegram(kind_of(Kind::status), {DeviceType::gateway, 7}, {DeviceType::governor, 3}, 8);
    for (int i = 0; i < 20; ++i) {
        gateway_end_.receive(foreign, now_);
        run_for(100'000);
        EXPECT_EQ(gateway_.state(), GatewayState::undefined);
        EXPECT_EQ(errors(), 1U << 11);  // 12422
    }
    can2_.take();
    run_for(2'000'000);
    EXPECT_EQ(gateway_.state(), GatewayState::pre_operational);
    const std::vector<frame::Frame> sent = can2_.take();
    EXPECT_EQ(std::count(sent.begin(), sent.end(), make_frame(0x705, {0x00})), 1);
}

TEST_F(Exchange, leaves_room_on_can1_whatever_comes_on_can2) {
    start();
    run_for(1'000'000);
    std::size_t telegrams = 0;
    lost_to_governor_ = [&telegrams](const frame::Frame&) {
        ++telegrams;
        return false;
    };
    for (int cycles = 0; cycles < 64; ++cycles) {
        for (int i = 0; i < 50; ++i) {
            gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::enter_pre_operational, 5), now_);
            gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), now_);
            gateway_.receive(make_frame(0x305, {0x34, 0x12}), now_);
            gateway_end_.poll(now_);
        }
        cycle();
    }
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    // In each main cycle at most the status, one receive PDO and, ten times a second, both error telegrams.
    EXPECT_LE(telegrams, 64U * 2 + 11 * 3);
    EXPECT_GE(received_.size(), 60U);
}

TEST_F(Exchange, tells_the_governor_of_an_operational_that_was_left_and_entered_at_once) {
    start();
    const std::uint8_t entries = status_.operational_entries;
    gateway_.receive(make_frame(0x305, {0x34, 0x12}), now_);
    gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::enter_pre_operational, 5), now_);
    gateway_.receive(canopen::nmt_frame(canopen::NmtCommand::start, 5), now_);
    cycle();
    EXPECT_EQ(status_.state, GatewayState::operational);
    EXPECT_EQ(status_.operational_entries, entries + 1);
    EXPECT_TRUE(received_.empty());  // came before the entry
}

TEST_F(Exchange, gives_all_transmit_pdos_words_of_one_main_cycle) {
    start();
    std::size_t both = 0;
    for (std::uint16_t value = 1; value < 1000; ++value) {
        data_.analogue[0].fill(value);
        data_.analogue[1].fill(value);
        to_gateway_.room = value % 5;
        cycle();
        std::optional<frame::Frame> tpdo4;
        for (const frame::Frame& frame : can2_.take()) {
            if (frame.id == 0x485) {
                tpdo4 = frame;
            } else if (frame.id == tpdo5_id && tpdo4) {
                ++both;
                EXPECT_EQ(wire::load_u16(&frame.data[0]), wire::load_u16(&tpdo4->data[6]));
            }
        }
    }
    EXPECT_GT(both, 60U);
}

TEST_F(Exchange, keeps_the_rhythm_when_can1_is_slower_than_the_governor) {
    start();
    std::size_t sent = 0;
    for (std::uint16_t value = 1; value <= 1200; ++value) {
        data_.analogue[0].fill(value);
        data_.analogue[1].fill(value);
        to_gateway_.room = 1;  // one telegram per call: three, four main cycles for a whole set
        cycle();
        for (const frame::Frame& frame : can2_.take()) {
            sent += frame.id == tpdo5_id ? 1U : 0U;
        }
    }
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
    EXPECT_NEAR(static_cast<double>(sent), 1200.0 / 12, 1);  // TPDO5: every 12 main cycles
}

}  // namespace
}  // namespace cgw::link
