#include "simulation/plant.hpp"

namespace cgw::simulation {

unsigned bus_bit_rate_kbit(const image::Image& image) {
    const image::Bus can2 = image.can2();
    return can2.manual_timing ? manual_bit_rate_kbit : can2.bit_rate_kbit;
}

Plant::Plant(const image::Image& image)
    : bus_(bus_bit_rate_kbit(image)),
      governor_(image),
      gateway_(bus_, governor_),
      status_(gateway_.gateway.open(image, 0)) {
    governor_.connect(gateway_.gateway);
    bus_.attach_clock(governor_);
}

}  // namespace cgw::simulation
