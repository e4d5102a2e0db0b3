// The 2048 identifiers of a bus: who has them, which two nodes quarrel about, which are free.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "network/message.hpp"

namespace cgw::network {

enum class Use : std::uint8_t {
    taken,
    conflict,    // by two
    free,        // 680h..6DFh, which CiA 301 leaves to everybody
    restricted,  // CiA 301 gives it to no PDO
    node_bound,  // by default of a node that is not there, or a service that is not used
};
std::string_view to_text(Use use);  // "taken", "conflict", "free", "restricted", "node-bound"

// Identifiers with one use; of those taken each one is a range of its own.
struct IdentifierRange {
    std::uint16_t first = 0;
    std::uint16_t last = 0;
    Use use = Use::free;
    std::vector<std::string> owners{};  // labels of messages
};

// All identifiers in ascending order. Messages as they come from plants and nodes, before they are merged.
std::vector<IdentifierRange> identifier_map(std::span<const Message> messages);

// The first identifiers that nobody has: 680h..6DFh first, then what is bound to nodes that are not there.
std::vector<std::uint16_t> free_identifiers(std::span<const Message> messages, std::size_t count);

// 16 lines of 128 identifiers, two in each character, with their legend; at most 80 columns.
std::string identifier_strip(std::span<const IdentifierRange> map);

}  // namespace cgw::network
