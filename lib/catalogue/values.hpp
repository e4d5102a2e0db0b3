// The forms of values in a catalogue: names, lines of text, pairs of limits.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "catalogue/cells.hpp"

namespace cgw::catalogue {

inline constexpr std::size_t longest_name = 64;
inline constexpr std::string_view name_marks = "_:./-";  // in names beside letters and digits
inline constexpr std::size_t longest_unit = 16;          // bytes; a table's column, a DBC's unit
inline constexpr std::array<std::uint8_t, 2> word_widths{8, 16};
// Raw values that a word of either sign can have.
inline constexpr std::int32_t lowest_raw = std::numeric_limits<std::int16_t>::min();
inline constexpr std::int32_t highest_raw = std::numeric_limits<std::uint16_t>::max();

// A letter, then letters, digits and name_marks, so that a name is never mistaken for a number or an element.
bool is_name(std::string_view text);

// "409 CanBaudrate"
bool is_number_and_name(std::string_view text);

// Not empty, no control characters.
bool is_line(std::string_view text);

// [low, high] of finite numbers, low <= high; nullopt after a finding.
std::optional<std::pair<double, double>> read_pair(const toml::Node& value, std::string_view cell,
                                                   const Reporter& report);

struct Limit {
    std::optional<double> constant;
    std::uint16_t reference = 0;  // the parameter that holds the limit; 0: the constant holds
};

struct Limits {
    Limit low;
    Limit high;
};

// [0.0, { parameter = 987 }]: numbers or references; two numbers must ascend. nullopt after a finding.
std::optional<Limits> read_limits(const toml::Node& value, const Reporter& report);

}  // namespace cgw::catalogue
