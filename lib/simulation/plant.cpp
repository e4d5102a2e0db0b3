#include "simulation/plant.hpp"

namespace cgw::simulation {

unsigned bus_bit_rate_kbit(const image::Bus& bus) {
    return bus.manual_timing ? manual_bit_rate_kbit : bus.bit_rate_kbit;
}

Plant::Plant(const image::Image& gateway, const image::Image& governor)
    : gateway_image_(&gateway),
      can1_(bus_bit_rate_kbit(gateway.can1())),
      can2_(bus_bit_rate_kbit(gateway.can2())),
      governor_(can1_, governor),
      gateway_(can1_, can2_) {
    reset_gateway();
}

void Plant::reset_gateway() {
    gateway_.link.open(*gateway_image_, ++gateway_boot_);
    status_ = gateway_.gateway.open(*gateway_image_, now());
}

void Plant::reset_governor() {
    governor_.reset();
}

}  // namespace cgw::simulation
