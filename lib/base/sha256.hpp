// SHA-256 (FIPS 180-4). Guards against accidents, not against tampering.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace cgw::base {

using Sha256 = std::array<std::uint8_t, 32>;

Sha256 sha256(std::span<const std::uint8_t> bytes);

// Lower-case hexadecimal, two digits a byte.
std::string to_hex(std::span<const std::uint8_t> bytes);

}  // namespace cgw::base
