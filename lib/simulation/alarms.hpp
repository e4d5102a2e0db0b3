// What the governor makes of the engine's measured values: alarms, and the emergency stop. The manuals print
// no error numbers for them, so they show in the engine state only (D48).
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

#include "canopen/protocol.hpp"
#include "simulation/engine.hpp"

namespace cgw::simulation {

using canopen::Time;

enum class Alarm : std::uint8_t {
    low_oil_pressure,
    lost_oil_pressure,
    hot_coolant,
    overheated_coolant,
    hot_charge_air,
    overspeed,
};
inline constexpr std::size_t alarm_count = 6;

enum class Side : std::uint8_t { below, above };

// When a value means something.
enum class Watched : std::uint8_t {
    always,
    running,  // once the engine has run for `run_up_time`
};
inline constexpr Time run_up_time = 3'000'000;  // us

struct AlarmRow {
    Alarm alarm;
    std::string_view name;  // in scenarios
    std::string_view text;  // for people
    double (*value)(const EngineState& engine);
    std::string_view unit;
    int decimals;
    Side side;        // of the limit, where the alarm is
    double limit;     // beyond it for `delay`: the alarm rises
    double released;  // back at this value the cause is gone
    Time delay;       // us
    Watched watched;
    bool stops;  // the engine; stays until errors are cleared
};

// One row per alarm, in the order of Alarm.
std::span<const AlarmRow, alarm_count> alarm_rows();

class EngineAlarms {
  public:
    // After each main cycle, `passed` after the one before.
    void follow(const EngineState& engine, Time passed);

    // "Clear errors". Ends the alarms that stopped the engine, once it stands and their cause is gone; before
    // that it does nothing. All others end by themselves.
    void clear(const EngineState& engine);

    bool present(Alarm alarm) const { return present_.test(static_cast<std::size_t>(alarm)); }
    bool any() const { return present_.any(); }
    bool emergency_stop() const;

  private:
    bool watched(const AlarmRow& row) const { return row.watched == Watched::always || ran_ >= run_up_time; }
    bool cause_gone(const AlarmRow& row, const EngineState& engine) const;

    std::bitset<alarm_count> present_;
    std::array<Time, alarm_count> beyond_{};  // for how long
    Time ran_ = 0;                            // since the engine has been running
};

}  // namespace cgw::simulation
