// What a run tells of itself, one line per event.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "canopen/protocol.hpp"

namespace cgw::scenario {

using canopen::Time;

enum class EventKind : std::uint8_t {
    boot_up,   // heard by the PLC
    command,   // NMT, whoever sent it
    state,     // of the gateway
    error,     // comes or goes
    monitor,   // an RPDO or the heartbeat is late, or in time again
    link,      // the governor was refused
    engine,    // starts, runs, runs down, stands
    alarm,     // of the engine, comes or goes
    answer,    // to an SDO request of the PLC
    step,      // of the scenario
    expected,  // an expectation, met or not
};

std::string_view to_text(EventKind kind);  // "boot-up", "nmt", …, at most 8 characters

struct Event {
    Time time = 0;
    EventKind kind = EventKind::state;
    std::string text;
    bool bad = false;  // an error that comes, an expectation that is not met
};

using EventListener = std::function<void(const Event&)>;

// "   2.500 s  state    Operational", at most 80 columns, no line feed. What was expected is `ok` or
// `FAILED`.
std::string line_of(const Event& event);
std::string seconds_text(Time time);  // "   2.500 s"

}  // namespace cgw::scenario
