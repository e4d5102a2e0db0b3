// The forms of values in a catalogue: names, lines of text, pairs of limits.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "catalogue/cells.hpp"

namespace cgw::catalogue {

inline constexpr std::size_t longest_name = 64;

// A letter, then letters, digits and _ - : . /, so that a name is never mistaken for a number or an element.
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
