// Little-endian access: no alignment needed, the same result on every machine.
// The caller guarantees that the bytes are there; these functions check nothing.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

namespace cgw::wire {

// Where bytes are stored in this order and every address can be reached, a value is one access. The compiler
// finds that out by itself only where nothing around tempts it to work on the bytes one by one.
#if defined(__x86_64__) || defined(__i386__) || defined(__aarch64__) || defined(__ARM_FEATURE_UNALIGNED)
inline constexpr bool direct_access = std::endian::native == std::endian::little;
#else
inline constexpr bool direct_access = false;
#endif

constexpr std::uint16_t load_u16(const std::uint8_t* from) {
    if (direct_access && !std::is_constant_evaluated()) {
        std::uint16_t value = 0;
        __builtin_memcpy(&value, from, sizeof value);
        return value;
    }
    return static_cast<std::uint16_t>(from[0] | (from[1] << 8));
}

constexpr std::uint32_t load_u32(const std::uint8_t* from) {
    if (direct_access && !std::is_constant_evaluated()) {
        std::uint32_t value = 0;
        __builtin_memcpy(&value, from, sizeof value);
        return value;
    }
    return static_cast<std::uint32_t>(from[0]) | (static_cast<std::uint32_t>(from[1]) << 8) |
           (static_cast<std::uint32_t>(from[2]) << 16) | (static_cast<std::uint32_t>(from[3]) << 24);
}

constexpr void store_u16(std::uint8_t* to, std::uint16_t value) {
    if (direct_access && !std::is_constant_evaluated()) {
        __builtin_memcpy(to, &value, sizeof value);
        return;
    }
    to[0] = static_cast<std::uint8_t>(value);
    to[1] = static_cast<std::uint8_t>(value >> 8);
}

constexpr void store_u32(std::uint8_t* to, std::uint32_t value) {
    if (direct_access && !std::is_constant_evaluated()) {
        __builtin_memcpy(to, &value, sizeof value);
        return;
    }
    to[0] = static_cast<std::uint8_t>(value);
    to[1] = static_cast<std::uint8_t>(value >> 8);
    to[2] = static_cast<std::uint8_t>(value >> 16);
    to[3] = static_cast<std::uint8_t>(value >> 24);
}

}  // namespace cgw::wire
