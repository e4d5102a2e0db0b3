#include "scenario/engine_values.hpp"

#include <vector>

#include "scenario/act.hpp"

namespace cgw::scenario {
namespace {

using simulation::EngineState;

constexpr EngineValue table[] = {
    {"speed", "1/min", "", [](const EngineState& e) { return e.speed; }, 0},
    {"speed-setpoint", "1/min", "", [](const EngineState& e) { return e.speed_setpoint; }, 0},
    {"position", "%", "of the actuator", [](const EngineState& e) { return e.position; }, 1},
    {"load", "%", "of full load at this speed", [](const EngineState& e) { return e.load; }, 1},
    {"power", "%", "of full load at rated speed", [](const EngineState& e) { return e.power; }, 1},
    {"oil-pressure", "bar", "", [](const EngineState& e) { return e.oil_pressure; }, 2},
    {"boost-pressure", "bar", "", [](const EngineState& e) { return e.boost_pressure; }, 2},
    {"coolant-temperature", "°C", "", [](const EngineState& e) { return e.coolant_temperature; }, 1},
    {"exhaust-temperature", "°C", "", [](const EngineState& e) { return e.exhaust_temperature; }, 1},
};

}  // namespace

std::span<const EngineValue> engine_values() {
    return table;
}

std::span<const Word> engine_words() {
    static const std::vector<Word> words = [] {
        std::vector<Word> all;
        for (const EngineValue& row : table) {
            all.push_back({row.name, row.unit});
        }
        return all;
    }();
    return words;
}

}  // namespace cgw::scenario
