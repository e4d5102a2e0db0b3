// Bit times that a data frame with an 11-bit identifier takes on a CAN bus (ISO 11898-1), from its first bit
// to the end of the three bits between frames. Up to 8 data bytes.
#pragma once

#include <cstdint>
#include <span>

namespace cgw::network {

inline constexpr unsigned most_data_bytes = 8;

// Without any stuff bit.
constexpr std::uint32_t unstuffed_bits(unsigned bytes) {
    return 47 + 8 * bytes;
}

// With the most stuff bits that any identifier and content can have.
constexpr std::uint32_t worst_case_bits(unsigned bytes) {
    return 55 + 10 * bytes;
}

// With the stuff bits of this very frame, its CRC worked out.
std::uint32_t exact_bits(std::uint32_t identifier, std::span<const std::uint8_t> data);

// Expected with this identifier and length, when every content is as likely as any other. An estimate for
// average loads; nothing that must hold is worked out from it.
double average_bits(std::uint32_t identifier, unsigned bytes);

}  // namespace cgw::network
