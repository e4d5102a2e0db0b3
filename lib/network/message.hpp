// A message of a CANopen bus as plain data.
#pragma once

#include <cstdint>
#include <string>

#include "diagnostic/location.hpp"

namespace cgw::network {

enum class Kind : std::uint8_t { nmt, sync, emergency, pdo, sdo, heartbeat, other };

enum class Release : std::uint8_t {
    cyclic,  // once in each period
    event,   // now and then, at most once in each period: not in the average load
};

struct Message {
    std::uint32_t identifier = 0;  // 11 bits
    std::uint8_t bytes = 0;        // 0..8
    Kind kind = Kind::other;
    Release release = Release::cyclic;
    std::string name{};               // "TPDO5", "heartbeat"
    std::string sender{};             // "node 12"; empty: not known
    std::uint64_t period_us = 0;      // above 0
    std::uint64_t jitter_us = 0;      // how late it may be released
    std::uint64_t deadline_us = 0;    // from its release until it is through; 0: none
    std::uint64_t monitored_us = 0;   // who receives it takes its sender for dead after so long; 0: never
    bool assumed = false;             // nobody states when it is sent (D75)
    std::uint8_t sync_multiple = 0;   // sent with every so many SYNCs, 1..240, whoever sends those; 0: not
    bool receiver = false;            // told by who is to receive it; nobody says who sends it
    std::uint8_t received_bytes = 0;  // the fewest that a receiver takes
    std::uint8_t tpdo = 0;            // 1..16: a plant's
    // Whose, in the order in which they were given: 0, 1, .. plants, -1, -2, .. descriptions of other nodes.
    int plant = -1;
    diagnostic::Location where{};

    // "TPDO5 of node 12"
    std::string label() const { return sender.empty() ? name : name + " of " + sender; }
};

// D75: what nobody states.
namespace assumed {
inline constexpr std::uint64_t pdo_us = 100'000;          // a PDO without any time
inline constexpr std::uint64_t sdo_us = 100'000;          // one SDO request and its answer
inline constexpr std::uint64_t heartbeat_us = 1'000'000;  // of a listed node
inline constexpr std::uint64_t emergency_us = 1'000'000;  // of a node without inhibit time
inline constexpr std::uint64_t nmt_us = 1'000'000;
inline constexpr unsigned messages_in_monitored_time = 2;  // of what is monitored
}  // namespace assumed

}  // namespace cgw::network
