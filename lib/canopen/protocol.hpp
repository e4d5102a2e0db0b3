// What both ends of a CANopen bus share: identifiers, NMT commands and states (CiA 301), time.
#pragma once

#include <cstdint>

#include "facts/identifiers.hpp"

namespace cgw::canopen {

// Microseconds since any fixed moment. The core has no clock: time is handed in and never runs backwards.
using Time = std::uint64_t;
inline constexpr Time never = ~Time{0};

using facts::maximum_node_id;
inline constexpr std::uint8_t all_nodes = 0;  // NMT broadcast

namespace cob = facts::cob;

enum class NmtCommand : std::uint8_t {
    start = 0x01,
    stop = 0x02,
    enter_pre_operational = 0x80,
    reset_node = 0x81,
    reset_communication = 0x82,
};

// As a heartbeat carries it. `initialising` is the boot-up message and never a heartbeat.
enum class NmtState : std::uint8_t {
    initialising = 0x00,
    stopped = 0x04,
    operational = 0x05,
    pre_operational = 0x7F,
};

}  // namespace cgw::canopen
