// Who owns which CAN identifier by CiA 301's predefined connection set, and who must keep away from it.
#pragma once

#include <array>
#include <cstdint>

namespace cgw::facts {

// Completed with a node number, except NMT, SYNC and TIME. The names take the device's view.
namespace cob {
inline constexpr std::uint32_t nmt = 0x000;
inline constexpr std::uint32_t sync = 0x080;
inline constexpr std::uint32_t emergency = 0x080;
inline constexpr std::uint32_t time = 0x100;
inline constexpr std::array<std::uint16_t, 4> tpdo{0x180, 0x280, 0x380, 0x480};
inline constexpr std::array<std::uint16_t, 4> rpdo{0x200, 0x300, 0x400, 0x500};
inline constexpr std::uint32_t sdo_answer = 0x580;   // server to client
inline constexpr std::uint32_t sdo_request = 0x600;  // client to server
inline constexpr std::uint32_t heartbeat = 0x700;    // and boot-up
inline constexpr std::uint32_t node_mask = 0x07F;
inline constexpr std::uint32_t function_mask = 0x780;
inline constexpr std::uint16_t highest = 0x7FF;  // 11 bits
// True for base + node id, whatever the base.
constexpr bool follows_node(std::uint32_t identifier, std::uint32_t node_id) {
    return (identifier & node_mask) == node_id && (identifier & function_mask) != 0;
}
constexpr std::uint32_t of_other_node(std::uint32_t identifier, std::uint32_t node_id) {
    return (identifier & function_mask) | node_id;
}
}  // namespace cob

// CiA 301 gives these to nobody.
inline constexpr std::uint16_t first_free_identifier = 0x680;
inline constexpr std::uint16_t last_free_identifier = 0x6DF;
constexpr bool is_free_identifier(std::uint32_t identifier) {
    return identifier >= first_free_identifier && identifier <= last_free_identifier;
}

// CiA 301 version 4.2 gives these to no PDO.
struct RestrictedIdentifiers {
    std::uint16_t first;
    std::uint16_t last;
    const char* purpose;  // "CiA 301 …"
};
inline constexpr RestrictedIdentifiers restricted_identifiers[] = {
    {0x001, 0x07F, "restricts since version 4.2"},     {0x101, 0x180, "keeps for safety data (SRDO)"},
    {0x581, 0x5FF, "keeps for SDO answers"},           {0x601, 0x67F, "keeps for SDO requests"},
    {0x6E0, 0x6FF, "restricts since version 4.2"},     {0x701, 0x77F, "keeps for heartbeats"},
    {0x780, 0x7FF, "restricts, for LSS among others"},
};

inline constexpr std::uint8_t maximum_node_id = 127;

}  // namespace cgw::facts
