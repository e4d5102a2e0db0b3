#include "config/monitoring_time.hpp"

namespace cgw::config {

std::uint64_t milliseconds_for(std::uint64_t cycles, std::uint32_t main_cycle_us) {
    return (cycles * main_cycle_us + 999) / 1000;
}

bool trips_early(const CyclicTime& time) {
    return time.effective_us + 1000 <= std::uint64_t{time.asked_ms} * 1000;
}

std::optional<CyclicTime> next_time_that_works(const CyclicTime& time, std::uint32_t main_cycle_us,
                                               std::uint32_t most_cycles) {
    const std::uint64_t asked_us = std::uint64_t{time.asked_ms} * 1000;
    const std::uint64_t cycles = (asked_us + main_cycle_us - 1) / main_cycle_us;
    if (cycles > most_cycles) {
        return std::nullopt;
    }
    return cyclic_time(static_cast<std::uint32_t>(milliseconds_for(cycles, main_cycle_us)), main_cycle_us);
}

}  // namespace cgw::config
