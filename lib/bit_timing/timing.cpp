#include "bit_timing/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cgw::bit_timing {

namespace {

constexpr Register register_rows[] = {
    {"BRP", "brp", "prescaler", highest_prescaler, &Registers::prescaler},
    {"SJW", "sjw", "synchronisation jump width", longest_jump_width - 1, &Registers::sync_jump_width},
    {"SAM", "sam", "three samples a bit", 1, &Registers::sampling_mode},
    {"PS1", "ps1", "phase segment 1", longest_segment - 1, &Registers::phase_segment_1},
    {"PS2", "ps2", "phase segment 2", longest_segment - 1, &Registers::phase_segment_2},
    {"Prop", "prop", "propagation segment", longest_segment - 1, &Registers::prop_segment},
};

// Lengths as CiA 301 estimates them; sample points by D77.
constexpr StandardRate rate_rows[] = {
    {1'000'000, 25, 0.75, 0.90}, {800'000, 50, 0.75, 0.90},  {500'000, 100, 0.85, 0.90},
    {250'000, 250, 0.85, 0.90},  {125'000, 500, 0.85, 0.90}, {50'000, 1000, 0.85, 0.90},
    {20'000, 2500, 0.85, 0.90},  {10'000, 5000, 0.85, 0.90},
};

// Segments in TQ.
std::uint32_t prop(const Registers& registers) {
    return registers.prop_segment + 1;
}
std::uint32_t phase_1(const Registers& registers) {
    return registers.phase_segment_1 + 1;
}
std::uint32_t phase_2(const Registers& registers) {
    return registers.phase_segment_2 + 1;
}
std::uint32_t jump_width(const Registers& registers) {
    return registers.sync_jump_width + 1;
}

}  // namespace

std::span<const Register> registers() {
    return register_rows;
}

std::uint64_t Timing::clocks_per_quantum() const {
    return std::uint64_t{controller->clocks_per_step} * (std::uint64_t{registers.prescaler} + 1);
}

std::uint32_t Timing::quanta() const {
    return 1 + prop(registers) + phase_1(registers) + phase_2(registers);
}

double Timing::bit_rate() const {
    return static_cast<double>(clock_hz) / static_cast<double>(clocks_per_bit());
}

double Timing::quantum_ns() const {
    return 1e9 * static_cast<double>(clocks_per_quantum()) / clock_hz;
}

double Timing::sample_point() const {
    return static_cast<double>(quanta() - phase_2(registers)) / quanta();
}

double Timing::phase_tolerance() const {
    const double shorter = std::min(phase_1(registers), phase_2(registers));
    return shorter / (2.0 * (13.0 * quanta() - phase_2(registers)));
}

double Timing::jump_tolerance() const {
    return jump_width(registers) / (20.0 * quanta());
}

double Timing::tolerance() const {
    return std::min(phase_tolerance(), jump_tolerance());
}

std::vector<std::string> violations(const Timing& timing) {
    std::vector<std::string> found;
    const Registers& registers = timing.registers;
    for (const Register& row : register_rows) {
        if (registers.*row.member > row.highest) {
            found.push_back(fmt::format("{} is {}, its register ends at {}", row.name, registers.*row.member,
                                        row.highest));
        }
    }
    if (!found.empty()) {
        return found;
    }
    const Controller& controller = *timing.controller;
    const std::uint32_t second = phase_2(registers);
    const std::uint32_t jump = jump_width(registers);
    if (second < shortest_phase_2) {
        found.push_back(
            fmt::format("phase segment 2 has {} TQ, the controller needs {}", second, shortest_phase_2));
    }
    if (second >= shortest_phase_2 &&
        (jump > second || (controller.phase_2_above_jump_width && jump == second))) {
        found.push_back(fmt::format("phase segment 2 has {} TQ, which must be {} the jump width of {} TQ",
                                    second, controller.phase_2_above_jump_width ? "more than" : "at least",
                                    jump));
    }
    const std::uint32_t before =
        phase_1(registers) + (controller.phase_2_below_phase_1 ? 0 : prop(registers));
    if (second > before) {
        found.push_back(fmt::format(
            "phase segment 2 has {} TQ, which must be at most the {} TQ of {}", second, before,
            controller.phase_2_below_phase_1 ? "phase segment 1" : "propagation and phase segment 1"));
    }
    if (timing.quanta() < fewest_quanta || timing.quanta() > most_quanta) {
        found.push_back(fmt::format("a bit has {} TQ, it must have {} to {}", timing.quanta(), fewest_quanta,
                                    most_quanta));
    }
    if (controller.triple_needs_prescaler && registers.sampling_mode == 1 && registers.prescaler == 0) {
        found.emplace_back("three samples a bit need a prescaler register above 0");
    }
    return found;
}

std::optional<std::array<std::uint8_t, 3>> cnf_registers(const Timing& timing) {
    if (!timing.controller->has_cnf_registers) {
        return std::nullopt;
    }
    constexpr std::uint32_t segments_by_hand = 0x80;  // BTLMODE: PS2 is what CNF3 says
    const Registers& registers = timing.registers;
    return std::array{static_cast<std::uint8_t>(registers.sync_jump_width << 6 | registers.prescaler),
                      static_cast<std::uint8_t>(segments_by_hand | registers.sampling_mode << 6 |
                                                registers.phase_segment_1 << 3 | registers.prop_segment),
                      static_cast<std::uint8_t>(registers.phase_segment_2)};
}

std::span<const StandardRate> standard_rates() {
    return rate_rows;
}

const StandardRate* near_standard_rate(double bit_rate) {
    for (const StandardRate& row : rate_rows) {
        if (std::abs(bit_rate - row.bit_rate) <= rate_tolerance * row.bit_rate) {
            return &row;
        }
    }
    return nullptr;
}

BusLength bus_length(double bit_rate, double sample_point) {
    constexpr double ns_per_metre = 5;
    constexpr double ns_per_node = 200;
    const StandardRate* standard = nullptr;
    for (const StandardRate& row : rate_rows) {  // falling: the last one that is not slower
        if (row.bit_rate >= bit_rate * (1 - rate_tolerance)) {
            standard = &row;
        }
    }
    if (standard == nullptr || bit_rate <= 0) {
        return {};
    }
    const double until_sample_ns = 1e9 * sample_point / bit_rate;
    const double left_m = std::max(0.0, (until_sample_ns - 2 * ns_per_node) / (2 * ns_per_metre));
    if (left_m < standard->length_m) {
        return {static_cast<std::uint32_t>(left_m), true};
    }
    return {standard->length_m, false};
}

}  // namespace cgw::bit_timing
