// What happens to a gateway in real time, for whoever shows or records it.
#pragma once

#include <cstdint>
#include <string_view>

#include "device/governor_link.hpp"
#include "frame/frame.hpp"
#include "link/gateway_end.hpp"
#include "media/channel.hpp"

namespace cgw::runtime {

using media::Time;

// The gateway's two CAN connections: CAN1 to the governor, CAN2 to the CANopen network.
enum class Side : std::uint8_t { can1, can2 };

// No call may call back into the gateway.
class Events {
  public:
    virtual void status_changed(const device::GatewayStatus& before, const device::GatewayStatus& now) = 0;
    // `reason` is one line for people; the state may be the same as before.
    virtual void link_changed(Side side, media::LinkState state, std::string_view reason) = 0;
    virtual void frames_lost(Side side, std::uint64_t count) = 0;
    // The governor's half of the configuration is not the gateway's.
    virtual void governor_refused(const link::Refusal& refusal) = 0;
    // The program did not run for so long, in microseconds.
    virtual void left_out(Time time) = 0;
    // Every frame, received or sent.
    virtual void frame(Side side, const frame::Frame& frame) = 0;

  protected:
    ~Events() = default;
};

}  // namespace cgw::runtime
