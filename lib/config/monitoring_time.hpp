// Which monitoring times do what they say (D8, D9).
#pragma once

#include <cstdint>
#include <optional>

#include "config/configuration.hpp"

namespace cgw::config {

// The smallest whole ms that becomes at least so many main cycles.
std::uint64_t milliseconds_for(std::uint64_t cycles, std::uint32_t main_cycle_us);

// D9: what is sent exactly at the asked time comes too late. Less than 1 ms cannot be typed better: then the
// time is the smallest one of its number of cycles.
bool trips_early(const CyclicTime& time);

// The shortest time that lasts no shorter than was asked; nullopt where the device does not count so far.
std::optional<CyclicTime> next_time_that_works(const CyclicTime& time, std::uint32_t main_cycle_us,
                                               std::uint32_t most_cycles);

}  // namespace cgw::config
