#pragma once

#include "fuzz/targets.hpp"

namespace cgw::fuzz {

// A change or two of bytes at random, for the mutations of targets to build upon: libFuzzer's own in its
// program, else those of change_bytes.cpp.
std::size_t change_bytes(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);

}  // namespace cgw::fuzz
