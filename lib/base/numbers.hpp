// Locale-free number parsing and printing; nothing saturates, wraps or guesses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cgw::base {

// Whole text must be the number. `base` 2, 8, 10 or 16, no prefix; a leading '-' or '+' is accepted.
// Empty, trailing characters or a value beyond int64 give nullopt.
std::optional<std::int64_t> parse_integer(std::string_view text, int base = 10);

// Decimal point, optional exponent; infinities, NaN and overflow give nullopt.
std::optional<double> parse_real(std::string_view text);

// Shortest text that reads back as the same double; whole numbers print without a point: 250, 0.5, -100.
std::string to_text(double value);

}  // namespace cgw::base
