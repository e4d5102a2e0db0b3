// Everything that is known of a running gateway at one moment, for the diagnostic view.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "device/gateway.hpp"
#include "image/image.hpp"
#include "media/channel.hpp"

namespace cgw::runtime {

// One of the two CAN connections.
struct BusView {
    std::string name;  // "hub:127.0.0.1:29536/can0", "a simulated governor"
    bool up = false;
    std::uint64_t received = 0;  // frames
    std::uint64_t sent = 0;
    std::uint64_t lost = 0;  // that came, and could not be taken
};

struct Diagnosis {
    const image::Image* image = nullptr;
    const device::Gateway* gateway = nullptr;
    BusView can1;
    BusView can2;
    std::uint32_t governors_heard = 0;  // bit n: governor n talks to this gateway
    media::Time now = 0;                // microseconds since the start
};

}  // namespace cgw::runtime
