// How long a frame occupies the bus.
#pragma once

#include "frame/frame.hpp"

namespace cgw::simulation {

// Bits of the frame as it travels: stuff bits as its content needs them, acknowledge and end of frame, and
// the three bits of interframe space.
unsigned bits_on_wire(const frame::Frame& frame);

}  // namespace cgw::simulation
