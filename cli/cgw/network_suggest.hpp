// `cgw network --suggest`: what to change so that the bus works below a load, as a patch to the files.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/cgw/network_inputs.hpp"

namespace cgw::cli {

struct Suggestion {
    bool reached = false;              // with these changes the bus works, below the load
    std::vector<std::string> changes;  // what and why, a line each
    std::string patch;                 // for patch -p0; empty: nothing to change
};

// How the bus is with the members as they are: whether it works, and its worst-case load.
struct BusState {
    bool works = false;
    double load = 0;
};
using AskBus = std::function<BusState(const BusMembers&)>;

// Identifiers that two have go to free ones, 680h..6DFh first; then the bit rate goes up, unless `keep_rate`;
// then the cycles of the TPDOs that take most of the bus are doubled. The members are changed on the way.
Suggestion suggest(BusMembers& members, const NetworkOptions& options, bool keep_rate, const AskBus& ask);

}  // namespace cgw::cli
