// Shortest and longest time between two frames of a cyclic TPDO on the simulated bus: governor, governor
// link, gateway and CAN2 with its arbitration, in simulated microseconds. Nothing here depends on the
// machine.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "gateway_operations.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"

namespace {

using cgw::simulation::Time;

constexpr Time second = 1'000'000;

class Intervals {
  public:
    explicit Intervals(std::uint32_t id) : id_(id) {}
    void see(const cgw::frame::Frame& frame, Time now) {
        if (frame.id != id_) {
            return;
        }
        if (last_ != 0) {
            shortest = std::min(shortest, now - last_);
            longest = std::max(longest, now - last_);
            ++count;
        }
        last_ = now;
    }
    Time shortest = cgw::canopen::never;
    Time longest = 0;
    std::uint64_t count = 0;

  private:
    std::uint32_t id_;
    Time last_ = 0;
};

// Other nodes' traffic: 8-byte frames, one each `period`, or without a pause.
class Traffic final : public cgw::simulation::Participant {
  public:
    Traffic(cgw::simulation::Bus& bus, std::uint32_t id, Time period)
        : port_(&bus.attach(*this)), period_(period) {
        frame_.id = id;
        frame_.length = 8;
    }
    Time poll(Time now) override {
        if (period_ == 0) {
            while (port_->send(frame_)) {
            }
            return cgw::canopen::never;
        }
        if (now >= due_) {
            port_->send(frame_);
            due_ = now + period_;
        }
        return due_;
    }

  private:
    cgw::frame::FramePort* port_;
    Time period_;
    Time due_ = 0;
    cgw::frame::Frame frame_;
};

struct Load {
    const char* name;
    std::uint32_t id;
    unsigned bits_per_frame;  // of time, so that the load is the same at every bit rate; 0: without a pause
};

// Identifier 001h wins against every frame of the gateway, 7DFh against none.
constexpr Load loads[] = {
    {"nothing else", 0x7DF, 1'000'000'000},
    {"half of it more urgent frames (001h)", 0x001, 254},
    {"full of less urgent frames (7DFh)", 0x7DF, 0},
};

void measure(const cgw::image::Image& image, const Load& load) {
    cgw::simulation::Plant plant(image);
    const std::uint8_t node = image.can2().own_node;
    cgw::simulation::MasterNode master(plant.can2(), node, second);
    plant.run_until(second);
    master.master().command(cgw::canopen::NmtCommand::start, node);
    plant.run_until(2 * second);
    Intervals intervals(image.pdo(cgw::facts::binary_tpdos).cob_id);
    plant.can2().observe([&](const cgw::frame::Frame& frame, Time now) { intervals.see(frame, now); });
    const unsigned bit_rate_kbit = cgw::simulation::bus_bit_rate_kbit(image.can2());
    Traffic traffic(plant.can2(), load.id, Time{load.bits_per_frame} * 1000 / bit_rate_kbit);
    const Time busy = plant.can2().busy_time();
    plant.run_until(62 * second);
    std::cout << "  CAN2 with " << load.name << ": "
              << (plant.can2().busy_time() - busy) / (60 * second / 100) << " % busy, " << intervals.count
              << " intervals, " << intervals.shortest << " to " << intervals.longest << " us\n";
}

void measure(const char* file) {
    const cgw::base::Bytes bytes = cgw::bench::image_of(file);
    cgw::image::Image image;
    if (cgw::image::Image::open(bytes, image) != cgw::image::Status::ok) {
        throw std::runtime_error("the image is refused");
    }
    std::cout << std::filesystem::path(file).filename().string() << ": TPDO4 every "
              << image.pdo(cgw::facts::binary_tpdos).effective_us << " us, CAN1 and CAN2 at "
              << cgw::simulation::bus_bit_rate_kbit(image.can1()) << " and "
              << cgw::simulation::bus_bit_rate_kbit(image.can2()) << " kbit/s, 60 simulated seconds\n";
    for (const Load& load : loads) {
        measure(image, load);
    }
}

}  // namespace

int main() {
    measure(CGW_SAMPLES "/genset.toml");
    measure(CGW_TEST_DATA "/full.toml");
}
