// The genset with a PLC, somebody who means no good, and the rules that watch.
#pragma once

#include <optional>
#include <random>
#include <string>

#include "simulation/installation.hpp"
#include "simulation/soak/rules.hpp"

namespace cgw::simulation::soak {

inline constexpr Time second = 1'000'000;

// Sends what it is given; the frames of a node that has lost its mind.
class Stranger final : public Participant {
  public:
    explicit Stranger(Bus& bus) : port_(&bus.attach(*this)) {}
    Time poll(Time /*now*/) override { return canopen::never; }
    void send(const frame::Frame& frame) { port_->send(frame); }

  private:
    frame::FramePort* port_;
};

// Tells the rules what happens in an installation, after every event on its buses.
class Inspector final : public Participant {
  public:
    explicit Inspector(Installation& installation);

    Time poll(Time now) override;
    Rules& rules() { return rules_; }
    void let_errors_flicker(bool flicker) { errors_flicker_ = flicker; }

    // After everything was mended.
    void settle();

  private:
    bool hides_states(Time now) const { return last_can1_ == now && last_can2_ == now; }

    Installation* installation_;
    Rules rules_;
    std::array<object::ObjectEntry, 7> binary_;  // 2000h:1..7
    bool errors_flicker_ = false;
    std::uint16_t engine_state_ = 0;
    Time last_can1_ = canopen::never;
    Time last_can2_ = canopen::never;
};

class World {
  public:
    explicit World(unsigned seed);

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_()) % limit; }
    Installation& installation() { return installation_; }
    Plant& plant() { return installation_.plant(); }
    Rules& rules() { return inspector_.rules(); }
    Inspector& inspector() { return inspector_; }
    Stranger& stranger() { return stranger_; }
    void run_for(Time time) { plant().run_until(plant().now() + time); }

    void reset_gateway();
    void connect(Plant::BusName bus, bool connected);

    // What an operator does after trouble, until the plant runs again; then it must be as it was.
    void recover();

  private:
    std::mt19937 random_;
    Installation installation_;
    Stranger stranger_;
    Inspector inspector_;
};

// The sample genset with TPDOs as fast as a governor can.
const image::Image& fast_genset();

}  // namespace cgw::simulation::soak
