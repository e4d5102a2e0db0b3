// Inside the partner room: the file in Structured Text, put together from these parts.
#pragma once

#include <string>
#include <vector>

#include "partner/half.hpp"

namespace cgw::partner {

// A signal as the PLC has it: a member of the structure of its PDO.
struct StMember {
    const signals::Signal* signal = nullptr;
    std::string name;
    bool real = false;  // physical value in REAL; else BOOL or the raw number in DINT
};

struct StFrame {
    const signals::Frame* frame = nullptr;
    std::string prefix;  // "GW12"
    std::string type;    // "GW12_TPDO4"
    std::vector<StMember> members;
};

StFrame st_frame(const Half& half, const signals::Frame& frame);

// TYPE … END_TYPE of the PDO.
std::string st_type(const StFrame& of);

// Raw number to physical value, frame to structure, and for receive PDOs structure to frame.
std::string st_functions(const StFrame& of);

// What all of them call.
std::string st_helpers(const std::string& prefix);

// A literal of type REAL: the nearest number of 32 bits.
std::string st_real(double value);

// Whether REAL holds the scaling: no number of it too large, none too small.
bool fits_real(const signals::Signal& signal);

}  // namespace cgw::partner
