// The families of CAN controllers whose registers cgw can read (D7), one row each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace cgw::bit_timing {

// How long the parts of a bit may be, in time quanta (TQ), and how a time quantum is made from the clock.
// The same in both families: segments of 1..8 TQ, a jump width of 1..4 TQ, 8..25 TQ in a bit, prescaler
// registers 0..63.
struct Controller {
    std::string_view name;          // as the parameter file and --family spell it
    std::string_view members;       // the devices that people know
    std::uint32_t clocks_per_step;  // clocks of one TQ per step of the prescaler: TQ = this × (BRP + 1) / f
    // Phase segment 2 against what stands before it; the data sheets' words differ.
    bool phase_2_above_jump_width;  // PS2 > SJW, else PS2 >= SJW
    bool phase_2_below_phase_1;     // PS2 <= PS1, else PS2 <= Prop + PS1
    bool triple_needs_prescaler;    // three samples a bit only with BRP > 0
    bool has_cnf_registers;         // registers are typed into tools as CNF1..CNF3
};

inline constexpr std::uint32_t fewest_quanta = 8;
inline constexpr std::uint32_t most_quanta = 25;
inline constexpr std::uint32_t longest_segment = 8;     // Prop, PS1, PS2, in TQ
inline constexpr std::uint32_t shortest_phase_2 = 2;    // the controller needs them to decide
inline constexpr std::uint32_t longest_jump_width = 4;  // SJW
inline constexpr std::uint32_t highest_prescaler = 63;  // register BRP

// MCP2515: data sheet DS20001801, section 5. AT90CAN: Atmel 7679, sections 19.4 and 19.10; both by D7.
inline constexpr Controller controllers[] = {
    {.name = "mcp2515",
     .members = "MCP2510, MCP2515",
     .clocks_per_step = 2,
     .phase_2_above_jump_width = true,
     .phase_2_below_phase_1 = false,
     .triple_needs_prescaler = false,
     .has_cnf_registers = true},
    {.name = "at90can",
     .members = "AT90CAN32/64/128, megaM1",
     .clocks_per_step = 1,
     .phase_2_above_jump_width = false,
     .phase_2_below_phase_1 = true,
     .triple_needs_prescaler = true,
     .has_cnf_registers = false},
};

inline constexpr auto controller_names = [] {
    std::array<std::string_view, std::size(controllers)> names{};
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = controllers[i].name;
    }
    return names;
}();

const Controller* find_controller(std::string_view name);  // nullptr: there is none

}  // namespace cgw::bit_timing
