// Gateway and simulated governor on one simulated CANopen bus, all from one configuration image.
#pragma once

#include "device/gateway.hpp"
#include "image/image.hpp"
#include "simulation/bus.hpp"
#include "simulation/governor.hpp"

namespace cgw::simulation {

// Bit rate of the CANopen bus; an image with manual timing states none, and gets `manual_bit_rate_kbit`.
inline constexpr unsigned manual_bit_rate_kbit = 125;
unsigned bus_bit_rate_kbit(const image::Image& image);

class Plant {
  public:
    // The image and its bytes outlive the plant.
    explicit Plant(const image::Image& image);

    // Why the gateway does not take the image; ok when it runs.
    device::OpenStatus status() const { return status_; }

    Bus& bus() { return bus_; }
    device::Gateway& gateway() { return gateway_.gateway; }
    SimulatedGovernor& governor() { return governor_; }

  private:
    struct GatewayNode final : Participant {
        GatewayNode(Bus& bus, device::GovernorLink& link) : gateway(bus.attach(*this), link) {}
        Time poll(Time now) override { return gateway.poll(now); }
        void receive(const frame::Frame& frame, Time now) override { gateway.receive(frame, now); }

        device::Gateway gateway;
    };

    Bus bus_;
    SimulatedGovernor governor_;
    GatewayNode gateway_;
    device::OpenStatus status_;
};

}  // namespace cgw::simulation
