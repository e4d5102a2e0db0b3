// Objects of CiA 301's communication profile that code refers to, and bits of their values.
#pragma once

#include <cstdint>

namespace cgw::facts {

namespace object {
inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t error_register = 0x1001;
inline constexpr std::uint16_t consumer_heartbeat = 0x1016;
inline constexpr std::uint16_t producer_heartbeat = 0x1017;
inline constexpr std::uint16_t identity = 0x1018;
inline constexpr std::uint8_t serial_number_sub = 4;  // of 1018h
inline constexpr std::uint16_t sdo_server = 0x1200;
// Of PDO 1; the others follow.
inline constexpr std::uint16_t rpdo_communication = 0x1400;
inline constexpr std::uint16_t rpdo_mapping = 0x1600;
inline constexpr std::uint16_t tpdo_communication = 0x1800;
inline constexpr std::uint16_t tpdo_mapping = 0x1A00;
inline constexpr std::uint8_t cob_id_sub = 1;  // of a PDO's communication record
inline constexpr std::uint8_t event_timer_sub = 5;
}  // namespace object

inline constexpr std::uint32_t pdo_not_valid = 0x80000000;  // bit 31 of a PDO's COB-ID

}  // namespace cgw::facts
