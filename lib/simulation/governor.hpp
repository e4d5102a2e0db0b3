// A simulated governor at the other end of the governor link: it initialises the gateway, runs an engine,
// fills the transmit PDOs and obeys what the receive PDOs bring.
#pragma once

#include <cstdint>

#include "device/gateway.hpp"
#include "device/governor_link.hpp"
#include "image/image.hpp"
#include "simulation/bus.hpp"
#include "simulation/engine.hpp"
#include "simulation/inputs.hpp"

namespace cgw::simulation {

class SimulatedGovernor final : public device::GovernorLink, public Participant {
  public:
    // Main cycles the exchange of initialisation telegrams takes here.
    static constexpr unsigned initialisation_cycles = 3;

    explicit SimulatedGovernor(const image::Image& image);

    // Before the first poll.
    void connect(device::Gateway& gateway) { gateway_ = &gateway; }

    Time poll(Time now) override;
    void status_changed(const device::GatewayStatus& status) override;
    void process_data(std::uint8_t rpdo, const device::PdoWords& words) override;

    const Engine& engine() const { return engine_; }
    const CanopenInputs& inputs() const { return inputs_; }

  private:
    void initialise_gateway(Time now);
    void run_engine();
    double percentage(std::uint16_t sensor_number, double substitute) const;
    device::GovernorData data() const;
    void fill_analogue(device::GovernorData& data) const;

    const image::Image* image_;
    device::Gateway* gateway_ = nullptr;
    device::GatewayState gateway_state_ = device::GatewayState::undefined;
    CanopenInputs inputs_;
    Engine engine_;
    Time cycle_;
    Time next_cycle_ = 0;
    std::uint64_t main_cycles_ = 0;
    unsigned initialising_ = 0;  // main cycles left of an initialisation; 0: none under way
};

}  // namespace cgw::simulation
