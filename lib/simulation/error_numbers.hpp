// Error bits to error numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "facts/gateway.hpp"

namespace cgw::simulation {

// The numbers of the bits of 2005h (12411 on), then of those of 2000h:1..6 (3000 on), each ascending.
std::vector<std::uint16_t> error_numbers(std::uint16_t canopen_errors,
                                         const std::array<std::uint16_t, facts::error_words>& words);

}  // namespace cgw::simulation
