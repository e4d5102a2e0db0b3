// Frames and signals as people call them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "signals/frames.hpp"

namespace cgw::signals {

// By name, "RPDO2", or identifier, "0x301" or "301h"; case does not matter. nullptr: no active PDO.
const Frame* find_frame(const std::vector<Frame>& frames, std::string_view name);

struct FoundSignal {
    const Signal* signal = nullptr;  // none, or more than one
    bool ambiguous = false;
};

// By the signal's own name, by number or name of a parameter behind it, also without the manual's first word
// (AssignIn_, Funct), and by the measurement that shows a sensor. Case does not matter. A signal's own name
// goes before all others.
FoundSignal find_signal(const Frame& frame, std::string_view name);

// The nearest name of a signal in the frame; "" when none is near.
std::string nearest_signal(const Frame& frame, std::string_view name);

}  // namespace cgw::signals
