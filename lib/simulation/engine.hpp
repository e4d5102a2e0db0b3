// A small, plausible engine with its speed governor: it starts, runs up, follows its setpoint, takes load,
// warms up. No claim to be any particular engine.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace cgw::simulation {

inline constexpr double idle_speed = 700;      // 1/min
inline constexpr double maximum_speed = 1800;  // 1/min
inline constexpr double rated_speed = 1500;    // 1/min; power is relative to full load at this speed

// What can break at the engine, until it is mended (simulation/faults.hpp has their names).
enum class EngineFault : std::uint8_t {
    oil_leak,           // the oil pressure falls slowly
    cooling_failure,    // the coolant gets hot
    charge_air_cooler,  // the charge air gets hot under load
    load_rejection,     // the load is gone at once
    actuator_stuck,     // the actuator stays where it is; only the emergency stop still cuts the fuel
};
inline constexpr std::size_t engine_fault_count = 5;

struct EngineInputs {
    bool idle_requested = false;  // 811
    bool load_enabled = true;     // 835
    double setpoint = 0;          // % of the way from idle to maximum speed
    double load = 60;             // %, taken once enabled and up to speed
    double ambient = 1013;        // mbar
    bool emergency_stop = false;  // the fuel is cut, whatever the actuator does
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
    bool fuel_cut = false;  // by the emergency stop
    bool ran_up = false;    // has been up to speed since it stood or its fuel was cut

    bool standing() const { return speed < 50; }
    bool up_to_speed() const { return speed >= 0.9 * idle_speed; }
    // Also one that is dragged down: only an engine that is being started has not run up yet.
    bool running() const { return ran_up; }
    bool at_setpoint() const;
};

class Engine {
  public:
    // `seconds` may be any positive time; longer ones are walked in small steps.
    void advance(double seconds, const EngineInputs& inputs);

    void report(EngineFault fault, bool present) { faults_.set(static_cast<std::size_t>(fault), present); }

    const EngineState& state() const { return state_; }

  private:
    void step(double seconds, const EngineInputs& inputs);
    void run_down(double seconds);
    void step_speed(double seconds, const EngineInputs& inputs);
    void step_load(double seconds, const EngineInputs& inputs);
    void step_media(double seconds);
    bool broken(EngineFault fault) const { return faults_.test(static_cast<std::size_t>(fault)); }
    double demand() const;

    EngineState state_;
    std::bitset<engine_fault_count> faults_;
    double age_ = 0;        // seconds since power-up, or since an emergency stop was lifted
    double oil_level_ = 1;  // 1: as much as there should be
};

}  // namespace cgw::simulation
