// Little-endian reads the image needs beyond wire/: 64-bit numbers. Private to the room.
#pragma once

#include <cstdint>

#include "wire/little_endian.hpp"

namespace cgw::image {

constexpr std::uint64_t load_u64(const std::uint8_t* from) {
    return wire::load_u32(from) | (static_cast<std::uint64_t>(wire::load_u32(from + 4)) << 32);
}

}  // namespace cgw::image
