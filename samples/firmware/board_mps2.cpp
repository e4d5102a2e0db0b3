// The board mps2-an385 in QEMU. Its clock is real; it has no CAN controllers, so files of the host stand for
// the buses (semihosting): what happens on them is taken from `received` at the time that stands with it, and
// sent frames go to `sent`.
#include "board.hpp"
#include "semihosting.hpp"

namespace board {
namespace {

enum Kind : std::uint8_t { data_frame, remote_frame, bus_goes_off, bus_comes_back, frames_lost };

// A frame in both files, or what a controller says of its bus; 24 bytes, little-endian.
struct Record {
    Time time = 0;  // microseconds
    std::uint32_t id = 0;
    std::uint8_t bus = 0;  // 1, 2; 0 in `received`: the end
    std::uint8_t length = 0;
    std::uint8_t extended = 0;
    std::uint8_t kind = data_frame;
    std::array<std::uint8_t, 8> data{};
};
static_assert(sizeof(Record) == 24);

// The timer of every Cortex-M: 24 bits, counting down.
struct SysTick {
    std::uint32_t control;
    std::uint32_t reload;
    std::uint32_t value;
};
SysTick volatile& systick = *reinterpret_cast<SysTick volatile*>(0xE000'E010);
constexpr std::uint32_t run_from_core_clock = 0x5;
constexpr std::uint32_t counter_mask = 0xFF'FFFF;
constexpr std::uint32_t ticks_per_microsecond = 25;

std::uint32_t volatile& leds = *reinterpret_cast<std::uint32_t volatile*>(0x4002'8000);

std::uint32_t last_counter;
std::uint32_t sent;
std::uint32_t received;
Record next;

struct Controller {
    bool started, off, lost;
};
Controller controllers[3];  // by number of the bus

void read_next() {
    if (semihosting::read(received, &next, sizeof next) != sizeof next) {
        semihosting::fail("the file `received` has no end record");
    }
}

void notice(Controller& controller, std::uint8_t kind) {
    if (kind == frames_lost) {
        controller.lost = true;
    } else {
        controller.off = kind == bus_goes_off;
    }
}

}  // namespace

Can can1(1);
Can can2(2);

void start() {
    systick.reload = counter_mask;
    systick.value = 0;
    systick.control = run_from_core_clock;
    last_counter = systick.value;
    received = semihosting::open("received", semihosting::read_binary);
    sent = semihosting::open("sent", semihosting::write_binary);
    read_next();
}

Time now() {
    static std::uint32_t ticks = 0;
    static Time time = 0;
    const std::uint32_t counter = systick.value;
    ticks += (last_counter - counter) & counter_mask;
    last_counter = counter;
    time += ticks / ticks_per_microsecond;
    ticks %= ticks_per_microsecond;
    return time;
}

bool Can::start(const cgw::image::Bus& bus) {
    const bool known_rate = bus.bit_rate_kbit == 125 || bus.bit_rate_kbit == 250 ||
                            bus.bit_rate_kbit == 500 || bus.bit_rate_kbit == 1000;
    controllers[number_].started = known_rate && !bus.manual_timing;
    return controllers[number_].started;
}

bool Can::send(const cgw::frame::Frame& frame) {
    const std::uint8_t kind = frame.remote ? remote_frame : data_frame;
    const Record record{now(), frame.id,  static_cast<std::uint8_t>(number_), frame.length, frame.extended,
                        kind,  frame.data};
    const Controller& controller = controllers[number_];
    return controller.started && !controller.off && semihosting::write(sent, &record, sizeof record);
}

bool Can::receive(cgw::frame::Frame& frame) {
    if (now() < next.time) {
        return false;
    }
    if (next.bus == 0) {
        semihosting::exit(0);
    }
    if (next.bus != number_) {
        return false;
    }
    const bool is_frame = next.kind <= remote_frame;
    if (is_frame) {
        frame = {next.id, next.length, next.extended != 0, next.kind == remote_frame, next.data};
    } else {
        notice(controllers[number_], next.kind);
    }
    read_next();
    return is_frame;
}

bool Can::bus_off() const {
    return controllers[number_].off;
}

bool Can::take_overflow() {
    const bool lost = controllers[number_].lost;
    controllers[number_].lost = false;
    return lost;
}

void feed_watchdog() {}

// Nothing interrupts this board.
void rest_until(Time) {}

Kept load() {
    Kept kept;
    const std::uint32_t file = semihosting::open("kept", semihosting::read_binary);
    if (file != semihosting::no_file) {
        if (semihosting::read(file, &kept, sizeof kept) != sizeof kept) {
            kept = {};
        }
        semihosting::close(file);
    }
    return kept;
}

void keep(const Kept& kept) {
    const std::uint32_t file = semihosting::open("kept", semihosting::write_binary);
    if (!semihosting::write(file, &kept, sizeof kept)) {
        semihosting::fail("the file `kept` cannot be written");
    }
    semihosting::close(file);
}

// An emulated board ends here, with the code as the exit code of QEMU; a real one goes on and blinks.
void record(unsigned refusal) {
    semihosting::exit(refusal);
}

void led(bool on) {
    leds = on ? 1 : 0;
}

}  // namespace board
