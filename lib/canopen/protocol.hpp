// What both ends of a CANopen bus share: identifiers, NMT commands and states (CiA 301), time.
#pragma once

#include <cstdint>

namespace cgw::canopen {

// Microseconds since any fixed moment. The core has no clock: time is handed in and never runs backwards.
using Time = std::uint64_t;
inline constexpr Time never = ~Time{0};

inline constexpr std::uint8_t maximum_node_id = 127;
inline constexpr std::uint8_t all_nodes = 0;  // NMT broadcast

// Predefined identifiers; all but NMT are completed with the node number.
namespace cob {
inline constexpr std::uint32_t nmt = 0x000;
inline constexpr std::uint32_t sdo_answer = 0x580;   // server to client
inline constexpr std::uint32_t sdo_request = 0x600;  // client to server
inline constexpr std::uint32_t heartbeat = 0x700;    // and boot-up
inline constexpr std::uint32_t node_mask = 0x07F;
inline constexpr std::uint32_t function_mask = 0x780;
}  // namespace cob

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
