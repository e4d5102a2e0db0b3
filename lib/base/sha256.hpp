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

// What is shown of a configuration id wherever one is shown: its first 8 bytes, 16 hexadecimal digits. `id`
// has 8 bytes at least.
std::string short_id(std::span<const std::uint8_t> id);

}  // namespace cgw::base
