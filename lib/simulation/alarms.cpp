#include "simulation/alarms.hpp"

#include <algorithm>

namespace cgw::simulation {
namespace {

using enum Alarm;
using enum Side;

double oil_pressure(const EngineState& engine) {
    return engine.oil_pressure;
}

double coolant_temperature(const EngineState& engine) {
    return engine.coolant_temperature;
}

constexpr AlarmRow table[] = {
    {low_oil_pressure, "low-oil-pressure", "low oil pressure", oil_pressure, "bar", 2, below, 2.0, 2.3,
     1'000'000, Watched::running, false},
    {lost_oil_pressure, "lost-oil-pressure", "oil pressure lost", oil_pressure, "bar", 2, below, 1.2, 2.3,
     500'000, Watched::running, true},
    {hot_coolant, "hot-coolant", "coolant is hot", coolant_temperature, "°C", 1, above, 98, 93, 2'000'000,
     Watched::always, false},
    {overheated_coolant, "overheated-coolant", "coolant is too hot", coolant_temperature, "°C", 1, above, 108,
     98, 2'000'000, Watched::always, true},
    {hot_charge_air, "hot-charge-air", "charge air is hot",
     [](const EngineState& engine) { return engine.charge_air_temperature; }, "°C", 1, above, 75, 70,
     2'000'000, Watched::always, false},
    {overspeed, "overspeed", "overspeed", [](const EngineState& engine) { return engine.speed; }, "1/min", 0,
     above, 1.15 * maximum_speed, maximum_speed, 0, Watched::always, true},
};
static_assert(std::size(table) == alarm_count);

bool is_beyond(const AlarmRow& row, double limit, double value) {
    return row.side == below ? value < limit : value > limit;
}

}  // namespace

std::span<const AlarmRow, alarm_count> alarm_rows() {
    return table;
}

void EngineAlarms::follow(const EngineState& engine, Time passed) {
    ran_ = engine.running() ? std::min(ran_ + passed, run_up_time) : 0;
    for (const AlarmRow& row : table) {
        const auto i = static_cast<std::size_t>(row.alarm);
        const bool beyond = watched(row) && is_beyond(row, row.limit, row.value(engine));
        beyond_[i] = beyond ? std::min(beyond_[i] + passed, row.delay) : 0;
        if (beyond && beyond_[i] >= row.delay) {
            present_.set(i);
        } else if (!row.stops && cause_gone(row, engine)) {
            present_.reset(i);
        }
    }
}

void EngineAlarms::clear(const EngineState& engine) {
    for (const AlarmRow& row : table) {
        if (row.stops && engine.standing() && cause_gone(row, engine)) {
            present_.reset(static_cast<std::size_t>(row.alarm));
        }
    }
}

bool EngineAlarms::emergency_stop() const {
    return std::any_of(std::begin(table), std::end(table),
                       [this](const AlarmRow& row) { return row.stops && present(row.alarm); });
}

bool EngineAlarms::cause_gone(const AlarmRow& row, const EngineState& engine) const {
    return !watched(row) || !is_beyond(row, row.released, row.value(engine));
}

}  // namespace cgw::simulation
