// Inside the partner room: the C header, put together from these parts. Names of functions and macros are
// <prefix>_<frame>_<verb>_<signal>: no signal is called like a word of the language, and no two names meet,
// since a verb has no underscore.
#pragma once

#include <string>

#include "partner/half.hpp"

namespace cgw::partner {

struct CFrame {
    const signals::Frame& frame;
    std::string prefix;  // "gw12"
    std::string type;    // "gw12_tpdo4"
    std::string macro;   // "GW12_TPDO4"
};

CFrame c_frame(const Half& half, const signals::Frame& frame);

// What a word of a frame means: place, unit, scaling and range as macros; raw and physical value read and
// written.
std::string c_word(const CFrame& of, const signals::Signal& signal);

// The single bits of a frame: an enumerator each, and functions for those that are switch functions.
std::string c_bits(const CFrame& of);

}  // namespace cgw::partner
