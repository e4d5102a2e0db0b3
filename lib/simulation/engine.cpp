#include "simulation/engine.hpp"

#include <algorithm>
#include <cmath>

namespace cgw::simulation {
namespace {

constexpr double longest_step = 0.01;   // seconds
constexpr double longest_advance = 10;  // seconds; nothing changes visibly after that
constexpr double start_delay = 0.1;     // seconds from power-up to cranking
constexpr double setpoint_rate = 1200;  // 1/min per second
constexpr double load_rate = 40;        // % per second
constexpr double speed_lag = 0.15;      // seconds
constexpr double speed_dip = 0.6;       // 1/min per % per second of load change
constexpr double position_gain = 0.06;  // % per 1/min of deviation
constexpr double position_lag = 0.05;   // seconds

constexpr double rejection_rate = 400;    // % per second
constexpr double run_down_rate = 250;     // 1/min per second, without fuel
constexpr double surplus_gain = 20;       // 1/min per second for each % of fuel that nothing takes up
constexpr double oil_left = 0.15;         // of the oil level, in the end
constexpr double leak_lag = 10;           // seconds
constexpr double refill_lag = 2;          // seconds
constexpr double lost_cooling = 40;       // K at rated speed
constexpr double charge_air_gain = 14;    // K per bar of boost pressure
constexpr double uncooled_air_gain = 45;  // likewise, without its cooler

// First-order lag towards `target`.
void approach(double& value, double target, double lag, double seconds) {
    value += (target - value) * std::min(1.0, seconds / lag);
}

void ramp(double& value, double target, double rate, double seconds) {
    value += std::clamp(target - value, -rate * seconds, rate * seconds);
}

}  // namespace

bool EngineState::at_setpoint() const {
    return running() && std::abs(speed - speed_setpoint) < 25;
}

void Engine::advance(double seconds, const EngineInputs& inputs) {
    double left = std::min(seconds, longest_advance);
    while (left > 0) {
        const double now = std::min(left, longest_step);
        step(now, inputs);
        left -= now;
    }
}

void Engine::step(double seconds, const EngineInputs& inputs) {
    age_ += seconds;
    state_.ambient = inputs.ambient;
    state_.fuel_cut = inputs.emergency_stop;
    if (inputs.emergency_stop) {
        run_down(seconds);
    } else if (age_ >= start_delay) {
        step_speed(seconds, inputs);
    }
    state_.ran_up = !state_.fuel_cut && !state_.standing() && (state_.ran_up || state_.up_to_speed());
    step_media(seconds);
}

void Engine::run_down(double seconds) {
    age_ = 0;
    state_.speed_setpoint = 0;
    state_.position_setpoint = 0;
    ramp(state_.load, 0, rejection_rate, seconds);
    ramp(state_.speed, 0, run_down_rate, seconds);
    if (!broken(EngineFault::actuator_stuck)) {
        approach(state_.position, 0, position_lag, seconds);
    }
    state_.power = std::clamp(state_.load * state_.speed / rated_speed, 0.0, 100.0);
}

void Engine::step_speed(double seconds, const EngineInputs& inputs) {
    const double wanted = inputs.idle_requested ? 0 : std::clamp(inputs.setpoint, 0.0, 100.0);
    const double target = idle_speed + wanted / 100 * (maximum_speed - idle_speed);
    ramp(state_.speed_setpoint, target, setpoint_rate, seconds);

    const bool stuck = broken(EngineFault::actuator_stuck);
    const double load_before = state_.load;
    step_load(seconds, inputs);
    if (stuck) {
        const double surplus = state_.position - demand();
        state_.speed = std::max(0.0, state_.speed + surplus_gain * surplus * seconds);
    } else {
        const double load_change = (state_.load - load_before) / seconds;
        approach(state_.speed, state_.speed_setpoint - speed_dip * load_change, speed_lag, seconds);
    }

    const double deviation = state_.speed_setpoint - state_.speed;
    state_.position_setpoint = std::clamp(demand() + position_gain * deviation, 0.0, 100.0);
    if (!stuck) {
        approach(state_.position, state_.position_setpoint, position_lag, seconds);
    }
    state_.power = std::clamp(state_.load * state_.speed / rated_speed, 0.0, 100.0);
}

void Engine::step_load(double seconds, const EngineInputs& inputs) {
    const bool rejected = broken(EngineFault::load_rejection);
    const bool may_load = inputs.load_enabled && state_.up_to_speed() && !inputs.idle_requested && !rejected;
    ramp(state_.load, may_load ? inputs.load : 0, rejected ? rejection_rate : load_rate, seconds);
}

// The position at which speed and load stay as they are.
double Engine::demand() const {
    return 6 + 9 * state_.speed / rated_speed + 0.65 * state_.load;
}

void Engine::step_media(double seconds) {
    const double speed = state_.speed / rated_speed;
    const double load = state_.power / 100;
    const bool leaks = broken(EngineFault::oil_leak);
    approach(oil_level_, leaks ? oil_left : 1, leaks ? leak_lag : refill_lag, seconds);
    approach(state_.oil_pressure, state_.standing() ? 0 : (1.4 + 3.0 * speed) * oil_level_, 0.5, seconds);
    approach(state_.boost_pressure, 0.1 * speed + 1.7 * load, 0.7, seconds);
    approach(state_.coolant_pressure, 0.2 + 1.3 * speed, 0.4, seconds);
    const double warming = 37 + (broken(EngineFault::cooling_failure) ? lost_cooling : 0);
    approach(state_.coolant_temperature, 45 + warming * std::min(1.0, speed) + 6 * load, 40, seconds);
    approach(state_.oil_temperature, 40 + 48 * std::min(1.0, speed) + 8 * load, 60, seconds);
    const double air_gain = broken(EngineFault::charge_air_cooler) ? uncooled_air_gain : charge_air_gain;
    approach(state_.charge_air_temperature, 30 + air_gain * state_.boost_pressure, 5, seconds);
    approach(state_.fuel_temperature, 32 + 8 * load, 90, seconds);
    approach(state_.exhaust_temperature, 40 + 150 * speed + 260 * load, 3, seconds);
}

}  // namespace cgw::simulation
