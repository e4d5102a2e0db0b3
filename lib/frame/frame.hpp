// A classic CAN frame and the narrow door through which the CANopen core sends one.
#pragma once

#include <array>
#include <cstdint>

namespace cgw::frame {

struct Frame {
    std::uint32_t id = 0;     // 11 bits, or 29 when `extended`
    std::uint8_t length = 0;  // data bytes, 0..8
    bool extended = false;
    bool remote = false;
    std::array<std::uint8_t, 8> data{};

    friend bool operator==(const Frame&, const Frame&) = default;
};

// Where frames leave a device. A full transmit queue is normal life, not an error.
class FramePort {
  public:
    // False: not now. The sender keeps what it wanted to say and offers it again later.
    virtual bool send(const Frame& frame) = 0;

  protected:
    ~FramePort() = default;
};

}  // namespace cgw::frame
