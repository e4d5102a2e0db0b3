// Gateway and simulated governor, CAN1 between them and the CANopen bus CAN2, all from one configuration
// image.
#pragma once

#include <array>
#include <set>

#include "device/gateway.hpp"
#include "image/image.hpp"
#include "link/gateway_end.hpp"
#include "simulation/bus.hpp"
#include "simulation/governor.hpp"

namespace cgw::simulation {

// Bit rate of a bus; an image with manual timing states none, and gets `manual_bit_rate_kbit`.
inline constexpr unsigned manual_bit_rate_kbit = 125;
unsigned bus_bit_rate_kbit(const image::Bus& bus);

class Plant {
  public:
    // The image and its bytes outlive the plant.
    explicit Plant(const image::Image& image) : Plant(image, image) {}
    // A governor that was set up with another configuration than the gateway.
    Plant(const image::Image& gateway, const image::Image& governor);

    // Why the gateway does not take the image; ok when it runs.
    device::OpenStatus status() const { return status_; }

    void run_until(Time end) { Bus::run_until(buses_, end); }
    Time now() const { return can2_.now(); }

    Bus& can1() { return can1_; }
    Bus& can2() { return can2_; }
    device::Gateway& gateway() { return gateway_.gateway; }
    const link::GatewayEnd& gateway_link() const { return gateway_.link; }
    SimulatedGovernor& governor() { return governor_; }

    // What the gateway offers to its port of CAN2.
    void watch_gateway(const Bus::PortWatch& watch) { can2_.watch_port(gateway_, watch); }

    // As if its supply had been interrupted.
    void reset_gateway();
    void reset_governor();

    // A cause of an error that the plant's surroundings bring about: there, or gone (simulation/faults.hpp).
    // One that is there is there after a reset as well.
    void report(device::Fault fault, bool present);
    void report(EngineFault fault, bool present) { governor_.report(fault, present); }

    // "Clear errors" at the gateway, which tells the governor.
    void clear_gateway_errors() { gateway_.link.clear_errors(now()); }

    // Cuts a bus, or mends it. Its controller at the gateway says so: 3070 or 3072. That fault is there as
    // long as the bus is cut or the fault is reported by name: mending the one does not mend the other.
    enum class BusName : std::uint8_t { can1, can2 };
    Bus& bus(BusName name) { return name == BusName::can1 ? can1_ : can2_; }
    void connect(BusName name, bool connected);

  private:
    // The gateway on CAN2, and its governor link on CAN1.
    struct GatewayNode final : Participant {
        GatewayNode(Bus& can1, Bus& can2)
            : link_side(*this), link(can1.attach(link_side)), gateway(can2.attach(*this), link) {
            link.connect(gateway);
        }
        Time poll(Time now) override { return gateway.poll(now); }
        void receive(const frame::Frame& frame, Time now) override { gateway.receive(frame, now); }

        struct LinkSide final : Participant {
            explicit LinkSide(GatewayNode& of) : node(&of) {}
            Time poll(Time now) override { return node->link.poll(now); }
            void receive(const frame::Frame& frame, Time now) override { node->link.receive(frame, now); }
            GatewayNode* node;
        };

        LinkSide link_side;
        link::GatewayEnd link;
        device::Gateway gateway;
    };

    bool present(device::Fault fault) const;
    void pass_on(device::Fault fault);

    const image::Image* gateway_image_;
    Bus can1_;
    Bus can2_;
    std::array<Bus*, 2> buses_{&can1_, &can2_};
    SimulatedGovernor governor_;
    GatewayNode gateway_;
    std::uint8_t gateway_boot_ = 0;
    std::set<device::Fault> causes_;
    device::OpenStatus status_;
};

}  // namespace cgw::simulation
