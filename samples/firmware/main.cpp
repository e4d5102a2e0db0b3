// A gateway firmware: everything but the board. Copy it; docs/firmware.md explains it.
#include <algorithm>

#include "board.hpp"
#include "device/gateway.hpp"
#include "image/area.hpp"
#include "link/gateway_end.hpp"

// The region of the image, from the linker script.
extern "C" const std::uint8_t cgw_config_begin[], cgw_config_end[];

namespace {

using namespace cgw;

// Refusals that are none of the image's own: far above image::Status, which may grow.
constexpr unsigned gateway_refusal = 30;  // + device::OpenStatus
constexpr unsigned bus_refusal = 40;      // + the number of the bus whose timing its controller cannot have

image::Image configuration;
link::GatewayEnd governor(board::can1);
device::Gateway gateway(board::can2, governor);
board::Kept kept;

void wait(board::Time duration) {
    const board::Time end = board::now() + duration;
    while (board::now() < end) {
        board::feed_watchdog();
    }
}

void blink(unsigned times, board::Time duration) {
    for (unsigned i = 0; i < times; ++i) {
        board::led(true);
        wait(duration);
        board::led(false);
        wait(300'000);
    }
    wait(1'000'000);
}

// Fails closed: no controller was started, and no default takes the image's place. The LED blinks the code's
// tens, long, and its ones, short, for ever; a reset would change nothing, so the watchdog is fed.
[[noreturn]] void refuse(unsigned code) {
    board::record(code);
    while (true) {
        blink(code / 10, 1'000'000);
        blink(code % 10, 200'000);
    }
}

void open_image() {
    const std::span<const std::uint8_t> region(cgw_config_begin, cgw_config_end);
    const image::Status status = image::Image::open(image::image_in(region), configuration);
    if (status != image::Status::ok) {
        refuse(static_cast<unsigned>(status));
    }
}

void open_gateway() {
    kept = board::load();
    ++kept.boot;
    board::keep(kept);
    gateway.restore(kept.sentinels);
    governor.connect(gateway);
    governor.open(configuration, kept.boot);
    const device::OpenStatus status = gateway.open(configuration, board::now());
    if (status != device::OpenStatus::ok) {
        refuse(gateway_refusal + static_cast<unsigned>(status));
    }
}

void start_buses() {
    if (!board::can1.start(configuration.can1())) {
        refuse(bus_refusal + 1);
    }
    if (!board::can2.start(configuration.can2())) {
        refuse(bus_refusal + 2);
    }
}

// What only the drivers see. A lost frame is over when it is noticed; a bus may stay off.
void report(board::Can& can, device::Fault bus, device::Fault overflow) {
    const board::Time now = board::now();
    gateway.report(bus, can.bus_off(), now);
    if (can.take_overflow()) {
        gateway.report(overflow, true, now);
        gateway.report(overflow, false, now);
    }
}

// Each sentinel counts to 255, so that memory is written 25 * 255 times at most, and once per reset.
void keep_errors() {
    if (gateway.errors().sentinels() != kept.sentinels) {
        kept.sentinels = gateway.errors().sentinels();
        board::keep(kept);
    }
}

void loop() {
    frame::Frame frame;
    while (board::can1.receive(frame)) {
        governor.receive(frame, board::now());
    }
    while (board::can2.receive(frame)) {
        gateway.receive(frame, board::now());
    }
    report(board::can1, device::Fault::can1_bus, device::Fault::can1_overflow);
    report(board::can2, device::Fault::can2_bus, device::Fault::can2_receive_overflow);
    const board::Time next = std::min(governor.poll(board::now()), gateway.poll(board::now()));
    keep_errors();
    board::feed_watchdog();
    if (!governor.pending() && !gateway.pending()) {
        board::rest_until(next);
    }
}

}  // namespace

int main() {
    board::start();
    open_image();
    open_gateway();
    start_buses();
    while (true) {
        loop();
    }
}
