// A C program that reads and writes the lines of frames.hpp with a plant's header.
#pragma once

#include <string>

#include "partner/half.hpp"

namespace cgw::test {

// Reads lines from standard input: "48C 0011…" is decoded, "RPDO2 50.5 …" encoded. C99 and C++.
std::string c_program(const partner::Half& half, const std::string& header);

}  // namespace cgw::test
