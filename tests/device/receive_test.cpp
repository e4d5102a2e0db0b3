// Receive PDOs: into the dictionary and on to the governor (manual 4.2, D25, D26, D28).
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::make_frame;

class GatewayReceive : public test::GatewayTest {};

TEST_F(GatewayReceive, stores_and_forwards_switches_and_sensor_flags_without_the_dummy) {
    start();
    gateway_.receive(make_frame(0x205, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66}), now_);
    EXPECT_EQ(upload(0x2003, 1), 0x2211U);
    EXPECT_EQ(upload(0x2003, 2), 0x6655U);
    ASSERT_EQ(link_.received.size(), 1U);
    EXPECT_EQ(link_.received[0].first, 1);
    EXPECT_EQ(link_.received[0].second, (PdoWords{0x2211, 0, 0x6655, 0}));
}

TEST_F(GatewayReceive, stores_and_forwards_sensors_by_channel) {
    start();
    gateway_.receive(make_frame(0x305, {0x34, 0x12}), now_);
    gateway_.receive(make_frame(0x405, {1, 1, 2, 2, 0x78, 0x56}), now_);
    EXPECT_EQ(upload(0x2004, 1), 0x1234U);
    EXPECT_EQ(upload(0x2004, 7), 0x5678U);
    EXPECT_EQ(upload(0x2004, 5), 0U);
    ASSERT_EQ(link_.received.size(), 2U);
    EXPECT_EQ(link_.received[0], (std::pair<std::uint8_t, PdoWords>{2, {0x1234, 0, 0, 0}}));
    EXPECT_EQ(link_.received[1], (std::pair<std::uint8_t, PdoWords>{3, {0, 0, 0x5678, 0}}));
}

TEST_F(GatewayReceive, does_not_process_a_short_one_and_takes_the_first_bytes_of_a_long_one) {
    start();
    gateway_.receive(make_frame(0x205, {1, 2, 3, 4, 5}), now_);
    EXPECT_TRUE(link_.received.empty());
    EXPECT_EQ(upload(0x2003, 1), 0U);
    gateway_.receive(make_frame(0x305, {1, 2, 3, 4, 5, 6, 7, 8}), now_);
    ASSERT_EQ(link_.received.size(), 1U);
    EXPECT_EQ(link_.received[0].second, (PdoWords{0x0201, 0, 0, 0}));
}

TEST_F(GatewayReceive, ignores_them_outside_operational_and_when_inactive) {
    boot_up();
    gateway_.receive(make_frame(0x305, {1, 2}), now_);
    nmt(NmtCommand::stop);
    gateway_.receive(make_frame(0x305, {1, 2}), now_);
    nmt(NmtCommand::start);
    gateway_.receive(make_frame(0x505, {1, 2, 3, 4, 5, 6, 7, 8}), now_);
    gateway_.receive(make_frame(0x306, {1, 2}), now_);
    port_.take();
    EXPECT_TRUE(link_.received.empty());
    EXPECT_EQ(upload(0x2004, 1), 0U);
}

}  // namespace
}  // namespace cgw::device
