// From the engine to the words of the transmit PDOs: which parameter shows which quantity.
#pragma once

#include <cstdint>

#include "image/image.hpp"
#include "simulation/engine.hpp"
#include "simulation/inputs.hpp"

namespace cgw::simulation {

// The word that measurement `number` shows `seconds` after power-up. A measurement 29nn whose sensor 9nn
// comes over CANopen shows what was received, or its substitute while that is faulty. A number this
// simulation has no model for swings between a quarter and three quarters of its internal range once in eight
// seconds, each number at its own phase.
std::uint16_t reading(const image::Image& image, std::uint16_t number, const EngineState& engine,
                      const CanopenInputs& inputs, double seconds);

// The word a healthy sensor 9nn would deliver at this engine: what a PLC measures and sends in an RPDO.
std::uint16_t sensor_word(const image::Image& image, std::uint16_t number, const EngineState& engine,
                          double seconds);

}  // namespace cgw::simulation
