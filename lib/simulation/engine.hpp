// A small, plausible engine with its speed governor: it starts, runs up, follows its setpoint, takes load,
// warms up. No claim to be any particular engine.
#pragma once

namespace cgw::simulation {

inline constexpr double idle_speed = 700;      // 1/min
inline constexpr double maximum_speed = 1800;  // 1/min
inline constexpr double rated_speed = 1500;    // 1/min; power is relative to full load at this speed

struct EngineInputs {
    bool idle_requested = false;  // 811
    bool load_enabled = true;     // 835
    double setpoint = 0;          // % of the way from idle to maximum speed
    double load = 60;             // %, taken once enabled and up to speed
    double ambient = 1013;        // mbar
};

struct EngineState {
    double speed = 0;                 // 1/min
    double speed_setpoint = 0;        // 1/min, ramped
    double position = 0;              // %, actuator
    double position_setpoint = 0;     // %
    double load = 0;                  // %
    double power = 0;                 // % of full load at rated speed
    double oil_pressure = 0;          // bar
    double boost_pressure = 0;        // bar
    double coolant_pressure = 0.2;    // bar
    double coolant_temperature = 45;  // °C, preheated
    double oil_temperature = 40;      // °C
    double charge_air_temperature = 30;
    double fuel_temperature = 32;
    double exhaust_temperature = 40;
    double ambient = 1013;  // mbar

    bool standing() const { return speed < 50; }
    bool running() const { return speed >= 0.9 * idle_speed; }
    bool at_setpoint() const;
};

class Engine {
  public:
    // `seconds` may be any positive time; longer ones are walked in small steps.
    void advance(double seconds, const EngineInputs& inputs);

    const EngineState& state() const { return state_; }

  private:
    void step(double seconds, const EngineInputs& inputs);
    void step_speed(double seconds, const EngineInputs& inputs);
    void step_media(double seconds);

    EngineState state_;
    double age_ = 0;  // seconds since power-up
};

}  // namespace cgw::simulation
