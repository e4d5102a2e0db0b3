#include "media/socketcan_frame.hpp"

#include <linux/can/error.h>

#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using test::make_frame;

can_frame error_frame(canid_t classes, std::uint8_t controller_status) {
    can_frame raw{};
    raw.can_id = CAN_ERR_FLAG | classes;
    raw.len = CAN_ERR_DLC;
    raw.data[1] = controller_status;
    return raw;
}

TEST(SocketCanFrame, carries_identifier_length_and_data) {
    const can_frame raw = to_kernel_frame(make_frame(0x7FF, {1, 2, 3}));
    EXPECT_EQ(raw.can_id, 0x7FFU);
    EXPECT_EQ(raw.len, 3);
    EXPECT_EQ(raw.data[2], 3);
    EXPECT_EQ(raw.data[3], 0);
}

TEST(SocketCanFrame, carries_the_flags_in_the_identifier) {
    frame::Frame frame = make_frame(0x123, {1});
    frame.extended = true;
    EXPECT_EQ(to_kernel_frame(frame).can_id, 0x80000123U);
    frame = {};
    frame.id = 0x705;
    frame.remote = true;
    frame.length = 4;
    EXPECT_EQ(to_kernel_frame(frame).can_id, 0x40000705U);
    EXPECT_EQ(to_kernel_frame(frame).len, 4);
}

TEST(SocketCanFrame, reads_what_it_makes) {
    frame::Frame extended = make_frame(0x1FFFFFFF, {8, 7, 6, 5, 4, 3, 2, 1});
    extended.extended = true;
    frame::Frame remote;
    remote.id = 0x700;
    remote.remote = true;
    remote.length = 8;
    for (const frame::Frame& frame : {make_frame(0, {}), make_frame(0x181, {1, 2}), extended, remote}) {
        EXPECT_EQ(from_kernel_frame(to_kernel_frame(frame)), frame);
    }
}

TEST(SocketCanFrame, cuts_what_is_longer_than_a_classic_frame) {
    can_frame raw{};
    raw.can_id = 0x100;
    raw.len = 64;
    raw.data[7] = 9;
    EXPECT_EQ(from_kernel_frame(raw), make_frame(0x100, {0, 0, 0, 0, 0, 0, 0, 9}));
}

TEST(SocketCanFrame, tells_error_frames_from_frames_of_the_bus) {
    EXPECT_TRUE(is_error_frame(error_frame(CAN_ERR_BUSOFF, 0)));
    EXPECT_FALSE(is_error_frame(to_kernel_frame(make_frame(0x7FF, {}))));
}

TEST(SocketCanFrame, reads_bus_off) {
    const ControllerReport report = controller_report(error_frame(CAN_ERR_BUSOFF, 0));
    EXPECT_TRUE(report.bus_off);
    EXPECT_FALSE(report.overflow || report.error_passive || report.error_active);
}

TEST(SocketCanFrame, reads_the_state_of_the_controller) {
    EXPECT_TRUE(controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW)).overflow);
    EXPECT_TRUE(controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE)).error_passive);
    EXPECT_TRUE(controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE)).error_passive);
    EXPECT_TRUE(controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE)).error_active);
    EXPECT_TRUE(controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING)).error_active);
}

TEST(SocketCanFrame, takes_a_controller_that_is_passive_in_one_direction_as_passive) {
    const ControllerReport report =
        controller_report(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_PASSIVE));
    EXPECT_TRUE(report.error_passive);
    EXPECT_FALSE(report.error_active);
}

TEST(SocketCanFrame, reads_the_status_only_where_the_report_is_about_the_controller) {
    const ControllerReport report = controller_report(error_frame(CAN_ERR_ACK, 0xFF));
    EXPECT_FALSE(report.bus_off || report.overflow || report.error_passive || report.error_active);
}

}  // namespace
}  // namespace cgw::media
