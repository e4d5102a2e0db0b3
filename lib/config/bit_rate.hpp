// The bit rate of manual bit timing (D7).
#pragma once

#include <cstdint>

#include "config/configuration.hpp"
#include "parameter/settings.hpp"

namespace cgw::config {

// In bit/s, rounded; from the gateway's registers and the clock and family that the file states. Does not
// hold for the governor, which has no propagation-segment register (D17).
std::uint32_t bit_rate(const BusTiming& timing, const parameter::BitTiming& controller);

}  // namespace cgw::config
