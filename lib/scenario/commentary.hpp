// Watches an installation and tells what changes: states, errors, commands, monitoring. Exact to the
// microsecond, since it is asked at every event on the buses.
#pragma once

#include <string>
#include <vector>

#include "canopen/sdo_client.hpp"
#include "link/governor_end.hpp"
#include "scenario/events.hpp"
#include "simulation/installation.hpp"

namespace cgw::scenario {

class Commentary final : public simulation::Participant {
  public:
    // Made after the installation, so that it sees what everybody else did.
    Commentary(simulation::Installation& installation, EventListener listener);

    Time poll(Time now) override;

    // The object of the transfer that the PLC has just begun.
    void asked(std::string object) { object_ = std::move(object); }
    void tell(EventKind kind, std::string text, bool bad = false) const;

  private:
    void watch_commands(const frame::Frame& frame);
    void watch_boot_ups();
    void watch_state();
    void watch_errors();
    void tell_errors(const std::vector<std::uint16_t>& errors, bool come) const;
    void watch_monitors();
    void watch_link();
    void watch_engine();
    void watch_alarms();
    void watch_answer();

    simulation::Installation* installation_;
    EventListener listener_;
    std::size_t boot_ups_ = 0;
    device::GatewayState state_ = device::GatewayState::undefined;
    std::vector<std::uint16_t> errors_;
    std::uint8_t late_rpdos_ = 0;
    bool heartbeat_lost_ = false;
    link::GovernorEnd::Phase phase_ = link::GovernorEnd::Phase::searching;
    unsigned failed_attempts_ = 0;
    std::string_view engine_;
    simulation::EngineAlarms alarms_;
    canopen::SdoClient::Status sdo_ = canopen::SdoClient::Status::idle;
    std::string object_;
};

}  // namespace cgw::scenario
