#include "media/socketcan_frame.hpp"

#include <linux/can/error.h>

#include <algorithm>

namespace cgw::media {
namespace {

constexpr std::size_t controller_status = 1;  // data byte of an error frame of class CAN_ERR_CRTL
constexpr unsigned passive = CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;
constexpr unsigned better_than_passive =
    CAN_ERR_CRTL_ACTIVE | CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING;

}  // namespace

can_frame to_kernel_frame(const frame::Frame& frame) {
    can_frame raw{};
    raw.can_id =
        frame.id | (frame.extended ? CAN_EFF_FLAG : canid_t{0}) | (frame.remote ? CAN_RTR_FLAG : canid_t{0});
    raw.len = std::min<std::uint8_t>(frame.length, CAN_MAX_DLEN);
    if (!frame.remote) {
        std::copy_n(frame.data.begin(), raw.len, raw.data);
    }
    return raw;
}

frame::Frame from_kernel_frame(const can_frame& raw) {
    frame::Frame frame;
    frame.extended = (raw.can_id & CAN_EFF_FLAG) != 0;
    frame.remote = (raw.can_id & CAN_RTR_FLAG) != 0;
    frame.id = raw.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.length = std::min<std::uint8_t>(raw.len, CAN_MAX_DLEN);
    if (!frame.remote) {
        std::copy_n(raw.data, frame.length, frame.data.begin());
    }
    return frame;
}

bool is_error_frame(const can_frame& raw) {
    return (raw.can_id & CAN_ERR_FLAG) != 0;
}

ControllerReport controller_report(const can_frame& raw) {
    ControllerReport report;
    report.bus_off = (raw.can_id & CAN_ERR_BUSOFF) != 0;
    if ((raw.can_id & CAN_ERR_CRTL) != 0) {
        const unsigned status = raw.data[controller_status];
        report.overflow = (status & CAN_ERR_CRTL_RX_OVERFLOW) != 0;
        report.error_passive = (status & passive) != 0;
        report.error_active = !report.error_passive && (status & better_than_passive) != 0;
    }
    return report;
}

}  // namespace cgw::media
