// Little-endian access, byte by byte: no alignment needed, the same result on every machine.
// The caller guarantees that the bytes are there; these functions check nothing.
#pragma once

#include <cstdint>

namespace cgw::wire {

constexpr std::uint16_t load_u16(const std::uint8_t* from) {
    return static_cast<std::uint16_t>(from[0] | (from[1] << 8));
}

constexpr std::uint32_t load_u32(const std::uint8_t* from) {
    return static_cast<std::uint32_t>(from[0]) | (static_cast<std::uint32_t>(from[1]) << 8) |
           (static_cast<std::uint32_t>(from[2]) << 16) | (static_cast<std::uint32_t>(from[3]) << 24);
}

constexpr void store_u16(std::uint8_t* to, std::uint16_t value) {
    to[0] = static_cast<std::uint8_t>(value);
    to[1] = static_cast<std::uint8_t>(value >> 8);
}

constexpr void store_u32(std::uint8_t* to, std::uint32_t value) {
    to[0] = static_cast<std::uint8_t>(value);
    to[1] = static_cast<std::uint8_t>(value >> 8);
    to[2] = static_cast<std::uint8_t>(value >> 16);
    to[3] = static_cast<std::uint8_t>(value >> 24);
}

}  // namespace cgw::wire
