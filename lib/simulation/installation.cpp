#include "simulation/installation.hpp"

#include "simulation/error_numbers.hpp"

namespace cgw::simulation {

Installation::Installation(const image::Image& gateway, const image::Image& governor)
    : image_(&gateway),
      plant_(gateway, governor),
      node_(plant_.can2(), gateway.can2().own_node, sdo_timeout),
      plc_(plant_.can2(), node_, gateway),
      jammer1_(plant_.can1()),
      jammer2_(plant_.can2()) {
    subscribe_transmit_pdos(node_, gateway);
    plc_.start_after_boot_up(true);
    plc_.set_healthy_outputs();
    plc_.send_outputs();
    plc_.send_heartbeat();
}

std::array<std::uint16_t, device::error_words> Installation::error_words() {
    std::array<std::uint16_t, device::error_words> words = plant_.governor().errors();
    const auto& own = plant_.gateway().errors().words();
    for (std::size_t i = 0; i < words.size(); ++i) {
        words[i] = static_cast<std::uint16_t>(words[i] | own[i]);
    }
    return words;
}

std::vector<std::uint16_t> Installation::error_numbers() {
    return simulation::error_numbers(plant_.gateway().errors().canopen_errors(), error_words());
}

}  // namespace cgw::simulation
