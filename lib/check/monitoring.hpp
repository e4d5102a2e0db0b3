// The monitoring times of RPDO1 to 4 and of the partner's heartbeat, and what each watches.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/checks.hpp"

namespace cgw::check {

// One monitoring time and what it watches.
struct Watch {
    parameter::Device device;
    std::uint16_t number;
    config::CyclicTime time;
    std::uint32_t main_cycle_us;
    std::uint32_t most_cycles;
    std::string watched;  // "RPDO2", "the heartbeat of node 127"
    bool active;
    std::string_view section;

    // A single main cycle leaves no room for a telegram that has to wait for the bus.
    bool is_short() const { return time.asked_ms != 0 && time.cycles < 2; }
};

std::vector<Watch> watches(const Context& context);

}  // namespace cgw::check
