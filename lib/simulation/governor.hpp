// A simulated governor at the other end of the governor link: it initialises the gateway, runs an engine,
// fills the transmit PDOs and obeys what the receive PDOs bring. It has errors of its own, those of CANopen,
// and alarms of its engine.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "device/governor_link.hpp"
#include "image/image.hpp"
#include "link/governor_end.hpp"
#include "simulation/alarms.hpp"
#include "simulation/bus.hpp"
#include "simulation/engine.hpp"
#include "simulation/inputs.hpp"

namespace cgw::simulation {

class SimulatedGovernor final : public link::GovernorListener, public Participant {
  public:
    // The image outlives the governor.
    SimulatedGovernor(Bus& can1, const image::Image& image);

    Time poll(Time now) override;
    void receive(const frame::Frame& frame, Time now) override { link_.receive(frame, now); }
    void gateway_status(const device::GatewayStatus& status) override { inputs_.follow(status); }
    void process_data(std::uint8_t rpdo, const device::PdoWords& words) override;

    void errors_cleared() override { alarms_.clear(engine_.state()); }

    const Engine& engine() const { return engine_; }
    const EngineAlarms& alarms() const { return alarms_; }
    const CanopenInputs& inputs() const { return inputs_; }
    const link::GovernorEnd& link() const { return link_; }

    // As if its supply had been interrupted; the engine goes on, and an emergency stop is not lifted.
    void reset();
    // "Clear errors", which also allows three more attempts at initialisation. An emergency stop is lifted as
    // EngineAlarms::clear says; then the engine starts again.
    void clear_errors();

    // Something at the engine breaks, or is mended.
    void report(EngineFault fault, bool present) { engine_.report(fault, present); }

    // Trouble of its own CAN controller, its 3070 and 3071; the gateway shows 12414 and 12415.
    void report_can_bus_error(bool present) { can_bus_error_ = present; }
    void report_can_comm_error(bool present) { can_comm_error_ = present; }

    // Called with what a main cycle is about to deliver, and may change it: for tests that must recognise the
    // words of one cycle.
    using Amend = std::function<void(device::GovernorData&)>;
    void amend_data(Amend amend) { amend_ = std::move(amend); }

    // Called with the words of each receive PDO that arrives.
    using Received = std::function<void(std::uint8_t rpdo, const device::PdoWords& words)>;
    void observe_process_data(Received received) { received_ = std::move(received); }

    // The governor's share of 2000h:1..6, as last sent.
    const std::array<std::uint16_t, device::error_words>& errors() const { return errors_; }

  private:
    void run_engine();
    std::uint8_t cycle_flags() const;
    double percentage(std::uint16_t sensor_number, double substitute) const;
    device::GovernorData data() const;
    void fill_analogue(device::GovernorData& data) const;

    const image::Image* image_;
    link::GovernorEnd link_;
    CanopenInputs inputs_;
    Engine engine_;
    EngineAlarms alarms_;
    Time cycle_;
    Time next_cycle_ = 0;
    std::uint64_t main_cycles_ = 0;
    std::uint8_t boot_ = 1;
    Amend amend_;
    Received received_;
    bool can_bus_error_ = false;
    bool can_comm_error_ = false;
    std::array<std::uint16_t, device::error_words> errors_{};
};

}  // namespace cgw::simulation
