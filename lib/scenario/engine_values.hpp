// What can be seen of the simulated engine, by name.
#pragma once

#include <span>
#include <string_view>

#include "simulation/engine.hpp"

namespace cgw::scenario {

struct EngineValue {
    std::string_view name;
    std::string_view unit;
    std::string_view text;
    double (*value)(const simulation::EngineState& engine);
    int decimals;
};

std::span<const EngineValue> engine_values();

}  // namespace cgw::scenario
