// The engine state of 2000h:7, TPDO3. The manuals print no bits of it (D22); these are the simulation's own.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "simulation/alarms.hpp"
#include "simulation/engine.hpp"

namespace cgw::simulation {

// What the bits are made of.
struct EngineCondition {
    const EngineState* engine;
    const EngineAlarms* alarms;
    bool sensor_faulty;
};

struct EngineStateBit {
    std::uint16_t mask;
    std::string_view name;  // in scenarios
    std::string_view text;
    bool (*set)(const EngineCondition& condition);
};

inline constexpr std::size_t engine_state_bit_count = 8;

// Bit 0 first.
std::span<const EngineStateBit, engine_state_bit_count> engine_state_bits();

std::uint16_t engine_state_word(const EngineCondition& condition);

// The engine in a word or two: "stands", "starts", "runs"; "runs down" after an emergency stop.
std::string_view engine_text(const EngineState& engine);

}  // namespace cgw::simulation
