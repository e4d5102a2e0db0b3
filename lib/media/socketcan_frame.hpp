// Frames and error reports of the kernel's CAN interfaces (linux/can.h, linux/can/error.h).
#pragma once

#include <linux/can.h>

#include "frame/frame.hpp"

namespace cgw::media {

can_frame to_kernel_frame(const frame::Frame& frame);

// Of a data or remote frame; more than 8 data bytes are cut.
frame::Frame from_kernel_frame(const can_frame& raw);

// An error frame is no frame of the bus: the interface's driver says with it what happens to its controller.
bool is_error_frame(const can_frame& raw);

struct ControllerReport {
    bool bus_off = false;
    bool overflow = false;  // the controller had no room for a frame that came
    bool error_passive = false;
    bool error_active = false;  // it recovered, at least to the warning level
};

ControllerReport controller_report(const can_frame& raw);

}  // namespace cgw::media
