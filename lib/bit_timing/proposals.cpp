#include "bit_timing/proposals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace cgw::bit_timing {

namespace {

double rate_error(const Timing& timing, const Wish& wish) {
    return std::abs(timing.bit_rate() - wish.bit_rate) / wish.bit_rate;
}

// Nearer than a thousandth of a percent is the same: whole numbers of clocks must not lose to rounding.
long steps_of(double fraction) {
    return std::lround(fraction * 1e5);
}

auto order(const Timing& timing, const Wish& wish) {
    return std::tuple(steps_of(rate_error(timing, wish)),
                      steps_of(std::abs(timing.sample_point() - wish.sample_point)),
                      -static_cast<long>(timing.quanta()));
}

std::optional<Timing> with_segments(const Wish& wish, std::uint32_t prescaler, std::uint32_t quanta,
                                    std::uint32_t phase_2) {
    if (quanta < phase_2 + 3) {  // SYNC, Prop and PS1 need one each
        return std::nullopt;
    }
    const std::uint32_t before = quanta - 1 - phase_2;
    const std::uint32_t prop = std::max(1U, before / 2);
    const std::uint32_t jump_width = std::clamp(phase_2 / 2, 1U, longest_jump_width);
    const Timing timing{.clock_hz = wish.clock_hz,
                        .controller = wish.controller,
                        .registers = {.prescaler = prescaler,
                                      .sync_jump_width = jump_width - 1,
                                      .phase_segment_1 = before - prop - 1,
                                      .phase_segment_2 = phase_2 - 1,
                                      .prop_segment = prop - 1}};
    return violations(timing).empty() ? std::optional(timing) : std::nullopt;
}

std::optional<Timing> best_segments(const Wish& wish, std::uint32_t prescaler, std::uint32_t quanta) {
    std::optional<Timing> best;
    for (std::uint32_t phase_2 = shortest_phase_2; phase_2 <= longest_segment; ++phase_2) {
        const std::optional<Timing> timing = with_segments(wish, prescaler, quanta, phase_2);
        if (timing && (!best || order(*timing, wish) < order(*best, wish))) {
            best = timing;
        }
    }
    return best;
}

}  // namespace

std::vector<Timing> propose(const Wish& wish) {
    std::vector<Timing> found;
    for (std::uint32_t prescaler = 0; prescaler <= highest_prescaler; ++prescaler) {
        for (std::uint32_t quanta = fewest_quanta; quanta <= most_quanta; ++quanta) {
            const std::optional<Timing> timing = best_segments(wish, prescaler, quanta);
            if (timing && rate_error(*timing, wish) <= rate_tolerance) {
                found.push_back(*timing);
            }
        }
    }
    std::stable_sort(found.begin(), found.end(), [&](const Timing& one, const Timing& other) {
        return order(one, wish) < order(other, wish);
    });
    return found;
}

}  // namespace cgw::bit_timing
