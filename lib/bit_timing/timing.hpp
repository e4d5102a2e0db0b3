// A bit on the bus: registers to bit rate, sample point, tolerance of the oscillators and length of the
// bus, and the rules that make it work (D7, D77; CiA 301, bit rates).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bit_timing/controller.hpp"

namespace cgw::bit_timing {

// Register values as parameters 410..415 and 420..425 hold them: the quantity less one.
struct Registers {
    std::uint32_t prescaler = 0;        // 0..63
    std::uint32_t sync_jump_width = 0;  // 0..3
    std::uint32_t sampling_mode = 0;    // 0: one sample a bit, 1: three
    std::uint32_t phase_segment_1 = 0;  // 0..7
    std::uint32_t phase_segment_2 = 0;  // 0..7; 0 is illegal
    std::uint32_t prop_segment = 0;     // 0..7

    friend bool operator==(const Registers&, const Registers&) = default;
};

// What a register is called and how far it goes, in the order of the parameters 410.. and 420...
struct Register {
    std::string_view name;  // "BRP"
    std::string_view key;   // "brp", for programs
    std::string_view text;  // "prescaler"
    std::uint32_t highest;
    std::uint32_t Registers::*member;
};
std::span<const Register> registers();

struct Timing {
    std::uint32_t clock_hz = 0;
    const Controller* controller = nullptr;
    Registers registers{};

    std::uint64_t clocks_per_quantum() const;
    std::uint32_t quanta() const;  // of a bit, with the one of SYNC
    std::uint64_t clocks_per_bit() const { return clocks_per_quantum() * quanta(); }
    double bit_rate() const;         // bit/s, not rounded
    double quantum_ns() const;       // duration of a TQ
    double sample_point() const;     // 0..1
    double tolerance() const;        // of each oscillator, 0..1: the smaller bound of FIELD-NOTES' two
    double phase_tolerance() const;  // min(PS1, PS2) / (2 (13 N - PS2)): a bit error is still signalled
    double jump_tolerance() const;   // SJW / (20 N): ten bits without an edge
};

// What the data sheet of the controller forbids, one sentence each: "phase segment 2 has 1 TQ, needs 2";
// empty when the registers work. Rates are not judged here.
std::vector<std::string> violations(const Timing& timing);

// CNF1..CNF3 of an MCP2515, as its tools and drivers show them (BTLMODE set); nullopt for families without.
std::optional<std::array<std::uint8_t, 3>> cnf_registers(const Timing& timing);

// A bit rate of CiA 301, table of bit rates: what every CANopen device may know.
struct StandardRate {
    std::uint32_t bit_rate;  // bit/s
    std::uint32_t length_m;  // longest bus by CiA
    double lowest_sample;    // sample points that work together with others
    double highest_sample;
};
inline constexpr double recommended_sample = 0.875;

std::span<const StandardRate> standard_rates();
// The one within `rate_tolerance` of the rate; nullptr: it is none.
const StandardRate* near_standard_rate(double bit_rate);
// Nodes of a bus whose rates are further apart (0.5 %) do not stay together.
inline constexpr double rate_tolerance = 0.005;

// The longest bus: CiA's length of the next higher standard rate, and what the sample point leaves: a bit
// must be everywhere and its acknowledge back before it is sampled. Assumes 5 ns/m and 200 ns in the
// electronics of each node (D77). 0: above 1 Mbit/s, or too early for any bus.
struct BusLength {
    std::uint32_t metres = 0;
    bool by_sample_point = false;  // false: by CiA's table
};
BusLength bus_length(double bit_rate, double sample_point);

}  // namespace cgw::bit_timing
