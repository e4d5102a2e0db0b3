// RPDO2 is monitored with 93.75 ms, the heartbeat of node 127 with 96 ms (D9, D44, D54, D55).
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::make_frame;

constexpr std::uint16_t receive_pdo_late = 1U << 2;  // 12413 in 2005h
constexpr std::uint16_t heartbeat_lost = 1U << 9;    // 12420

class GatewayMonitoring : public test::GatewayTest {
  protected:
    void watch_rpdo2() { plant_.rpdo(2).time = {100, 6, 93'750}; }
    void watch_partner() { plant_.configuration.heartbeat_consumer = {100, 6, 96'000}; }
    void rpdo2() { gateway_.receive(make_frame(0x305, {1, 0}), now_); }
    void heartbeat() { gateway_.receive(make_frame(0x77F, {0x05}), now_); }
    std::uint16_t errors() const { return gateway_.errors().canopen_errors(); }
};

TEST_F(GatewayMonitoring, tells_the_governor_which_rpdo_is_late) {
    watch_rpdo2();
    start();
    run_until(93'750);
    EXPECT_EQ(link_.status.late_rpdos, 0);
    run_until(110'000);
    EXPECT_EQ(link_.status.late_rpdos, 0b0010);
    EXPECT_EQ(errors(), receive_pdo_late);
    EXPECT_EQ(gateway_.state(), GatewayState::operational);
}

TEST_F(GatewayMonitoring, misses_an_rpdo_also_when_the_governor_sends_nothing) {
    watch_rpdo2();
    start();
    EXPECT_EQ(gateway_.poll(now_), 93'751U);
    gateway_.poll(93'751);
    EXPECT_EQ(errors(), receive_pdo_late);
}

TEST_F(GatewayMonitoring, takes_the_error_back_when_the_rpdo_keeps_its_time_again) {
    watch_rpdo2();
    start();
    run_until(200'000);
    rpdo2();
    EXPECT_EQ(errors(), receive_pdo_late);  // one telegram is no rhythm yet
    run_until(now_ + 50'000);
    rpdo2();
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(link_.status.late_rpdos, 0);
}

TEST_F(GatewayMonitoring, takes_the_error_back_when_operational_ends) {
    watch_rpdo2();
    watch_partner();
    start();
    run_until(200'000);
    EXPECT_EQ(errors(), receive_pdo_late | heartbeat_lost);
    nmt(NmtCommand::enter_pre_operational);
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(upload(0x2005, 0), 0U);
}

TEST_F(GatewayMonitoring, tells_the_governor_of_a_lost_heartbeat_and_of_its_return) {
    watch_partner();
    start();
    for (int i = 0; i < 10; ++i) {
        run_until(now_ + 80'000);
        heartbeat();
    }
    EXPECT_EQ(errors(), 0);
    run_until(now_ + 120'000);
    EXPECT_TRUE(link_.status.heartbeat_lost);
    EXPECT_EQ(errors(), heartbeat_lost);
    heartbeat();
    run_until(now_ + 80'000);
    heartbeat();
    EXPECT_FALSE(link_.status.heartbeat_lost);
    EXPECT_EQ(errors(), 0);
}

TEST_F(GatewayMonitoring, still_forwards_what_comes_late) {
    watch_rpdo2();
    start();
    run_until(500'000);
    rpdo2();
    ASSERT_EQ(link_.received.size(), 1U);
}

TEST_F(GatewayMonitoring, is_not_fooled_by_clearing_errors) {
    watch_partner();
    start();
    run_until(200'000);
    gateway_.clear_errors(now_);
    EXPECT_EQ(errors(), heartbeat_lost);
}

TEST_F(GatewayMonitoring, sends_the_error_bits_once_with_the_next_main_cycle) {
    watch_partner();
    start();
    const std::vector<frame::Frame> sent = run_until(200'000);
    // 3074 is bit 74: 2000h:5, first word of TPDO2.
    EXPECT_EQ(std::count(sent.begin(), sent.end(), make_frame(0x285, {0x00, 0x04, 0, 0})), 1);
}

}  // namespace
}  // namespace cgw::device
