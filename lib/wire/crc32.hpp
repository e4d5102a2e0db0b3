// CRC-32 (IEEE 802.3: polynomial 04C11DB7h reflected, initial and final value FFFFFFFFh).
// crc32("123456789") == CBF43926h.
#pragma once

#include <cstdint>
#include <span>

namespace cgw::wire {

std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace cgw::wire
