// Bytes from one place to another that does not overlap it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cgw::wire {

// A known number of bytes is one access each way where the machine can do it, with and without optimisation
// for size, hosted and with -ffreestanding: hence the compiler's own function.
inline void copy(const std::uint8_t* from, std::size_t bytes, std::uint8_t* to) {
    __builtin_memcpy(to, from, bytes);
}

}  // namespace cgw::wire
