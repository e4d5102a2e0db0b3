// What a board gives the gateway. For your board write one file that implements it, and leave main.cpp as it
// is; board_mps2.cpp does it for the board that QEMU emulates.
#pragma once

#include <array>
#include <cstdint>

#include "canopen/protocol.hpp"
#include "device/gateway_errors.hpp"
#include "frame/frame.hpp"
#include "image/image.hpp"

namespace board {

using cgw::canopen::Time;

// A CAN controller. It takes no part in its bus until start(): send() says "not now", and nothing is
// acknowledged.
class Can final : public cgw::frame::FramePort {
  public:
    explicit constexpr Can(unsigned number) : number_(number) {}

    // Bit rate, or the registers when the timing is manual. False: the controller cannot have it.
    bool start(const cgw::image::Bus& bus);

    // Copies the frame into a free transmit mailbox. False: none is free; the gateway offers the frame again.
    bool send(const cgw::frame::Frame& frame) override;
    // The oldest frame that the reception interrupt put into its queue.
    bool receive(cgw::frame::Frame& frame);

    bool bus_off() const;  // and not yet mended by initialising it again
    bool take_overflow();  // frames were lost since the last call

  private:
    unsigned number_;
};

extern Can can1;  // HEINZMANN CAN: the governor
extern Can can2;  // CANopen

// Clocks and pins. Both CAN controllers stay as a reset left them.
void start();

// Microseconds since start(): 64 bits, never backwards. Called at least every 0.6 s.
Time now();

void feed_watchdog();

// Sleeps until an interrupt comes, at the latest until that time and no longer than the watchdog and now()
// allow. Returns at once when a frame has come since the last look into the queues. Not sleeping at all is
// right, too.
void rest_until(Time deadline);

// What outlives a reset and the loss of power, in memory of the board's own.
struct Kept {
    std::uint8_t boot = 0;  // resets, counted
    std::array<std::uint8_t, cgw::device::GatewayErrors::error_count> sentinels{};
};
Kept load();  // all zero where nothing valid is kept
void keep(const Kept& kept);

// Why the gateway does not run, for whoever reads the board out later.
void record(unsigned refusal);
void led(bool on);

}  // namespace board
