// CAN1 inside the program, with a simulated governor at its other end.
#pragma once

#include "simulation/bus.hpp"
#include "simulation/governor.hpp"
#include "simulation/plant.hpp"

namespace cgw::runtime {

struct SimulatedCan1 {
    // `gateway_end` is the gateway's side of the bus.
    SimulatedCan1(const image::Image& image, simulation::Participant& gateway_end)
        : bus(simulation::bus_bit_rate_kbit(image.can1())),
          port(bus.attach(gateway_end)),
          governor(bus, image) {}

    simulation::Bus bus;
    frame::FramePort& port;
    simulation::SimulatedGovernor governor;
};

}  // namespace cgw::runtime
