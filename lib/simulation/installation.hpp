// A plant with a PLC at its CANopen bus, and with what may disturb it.
#pragma once

#include <vector>

#include "simulation/jammer.hpp"
#include "simulation/master_node.hpp"
#include "simulation/plant.hpp"
#include "simulation/plc.hpp"

namespace cgw::simulation {

class Installation {
  public:
    static constexpr Time sdo_timeout = 500'000;  // us

    // Images outlive the installation. The PLC runs from the start and starts the gateway after its boot-up.
    explicit Installation(const image::Image& image) : Installation(image, image) {}
    Installation(const image::Image& gateway, const image::Image& governor);

    const image::Image& image() const { return *image_; }  // the gateway's
    Plant& plant() { return plant_; }
    MasterNode& node() { return node_; }
    Plc& plc() { return plc_; }
    Jammer& jammer(Plant::BusName bus) { return bus == Plant::BusName::can1 ? jammer1_ : jammer2_; }
    Time now() const { return plant_.now(); }

    // Bits of 2000h:1..6 as the gateway shows them: the governor's, and its own.
    std::array<std::uint16_t, device::error_words> error_words();
    // Numbers of all errors that the gateway shows, of 2005h and of 2000h:1..6.
    std::vector<std::uint16_t> error_numbers();

  private:
    const image::Image* image_;
    Plant plant_;
    MasterNode node_;
    Plc plc_;
    Jammer jammer1_;
    Jammer jammer2_;
};

}  // namespace cgw::simulation
