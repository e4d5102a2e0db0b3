// Settings as the numbers the resolution works with. A value that the parameter cannot hold counts as not
// set: the finding is the input's, and nothing may be concluded from such a value.
#pragma once

#include <cmath>
#include <cstdint>

#include "config/numbers.hpp"
#include "parameter/settings.hpp"

namespace cgw::config {

// The whole number assigned to `number`, or 0 when it is absent, no whole number or outside lowest..highest.
inline std::int32_t whole(const parameter::ParameterSet& set, std::uint16_t number, std::int32_t lowest,
                          std::int32_t highest) {
    const double value = set.value(number);
    const bool usable = value >= lowest && value <= highest && value == std::floor(value);
    return usable ? static_cast<std::int32_t>(value) : 0;
}

template <typename Unsigned>
Unsigned setting(const parameter::ParameterSet& set, std::uint16_t number, std::int32_t highest) {
    return static_cast<Unsigned>(whole(set, number, 0, highest));
}

inline bool switched_on(const parameter::ParameterSet& set, std::uint16_t number) {
    return whole(set, number, 0, 1) == 1;
}

inline std::uint32_t time_ms(const parameter::ParameterSet& set, std::uint16_t number) {
    return setting<std::uint32_t>(set, number, static_cast<std::int32_t>(longest_time_ms));
}

}  // namespace cgw::config
