#include "simulation/engine_state_word.hpp"

namespace cgw::simulation {
namespace {

using Condition = EngineCondition;

bool starting(const EngineState& engine) {
    return !engine.standing() && !engine.running() && !engine.fuel_cut;
}

constexpr EngineStateBit table[] = {
    {0x01, "standing", "the engine stands", [](const Condition& c) { return c.engine->standing(); }},
    {0x02, "starting", "it is being started and has not run up yet",
     [](const Condition& c) { return starting(*c.engine); }},
    {0x04, "running", "it has run up; also when it is dragged down",
     [](const Condition& c) { return c.engine->running(); }},
    {0x08, "at-setpoint", "its speed is at the setpoint",
     [](const Condition& c) { return c.engine->at_setpoint(); }},
    {0x10, "loaded", "it carries load", [](const Condition& c) { return c.engine->load > 1; }},
    {0x20, "engine-alarm", "one of the alarms above", [](const Condition& c) { return c.alarms->any(); }},
    {0x40, "emergency-stop", "the governor has cut the fuel, until errors are cleared",
     [](const Condition& c) { return c.alarms->emergency_stop(); }},
    {0x80, "alarm", "one of the alarms above, or a faulty sensor",
     [](const Condition& c) { return c.alarms->any() || c.sensor_faulty; }},
};

}  // namespace

std::span<const EngineStateBit, engine_state_bit_count> engine_state_bits() {
    return table;
}

std::uint16_t engine_state_word(const EngineCondition& condition) {
    unsigned word = 0;
    for (const EngineStateBit& bit : table) {
        word |= bit.set(condition) ? bit.mask : 0U;
    }
    return static_cast<std::uint16_t>(word);
}

std::string_view engine_text(const EngineState& engine) {
    if (engine.standing()) {
        return "stands";
    }
    if (engine.fuel_cut) {
        return "runs down";
    }
    return engine.running() ? "runs" : "starts";
}

}  // namespace cgw::simulation
