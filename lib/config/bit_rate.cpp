#include "config/bit_rate.hpp"

namespace cgw::config {

std::uint32_t bit_rate(const BusTiming& timing, const parameter::BitTiming& controller) {
    const std::uint64_t clocks_per_prescale =
        controller.family == parameter::ControllerFamily::mcp2515 ? 2 : 1;
    const std::uint64_t clocks_per_quantum = clocks_per_prescale * (timing.prescaler + 1U);
    const std::uint64_t quanta =
        1 + (timing.prop_segment + 1U) + (timing.phase_segment_1 + 1U) + (timing.phase_segment_2 + 1U);
    const std::uint64_t clocks_per_bit = clocks_per_quantum * quanta;
    return static_cast<std::uint32_t>((controller.clock_hz + clocks_per_bit / 2) / clocks_per_bit);
}

}  // namespace cgw::config
