// The parameter numbers the CANopen side reads by name. Ranges and texts stand in the catalogues.
#pragma once

#include <array>
#include <cstdint>

namespace cgw::config {

namespace governor {
inline constexpr std::uint16_t start_up_delay = 400;
inline constexpr std::uint16_t own_node = 401;
inline constexpr std::uint16_t gateway_node = 403;
inline constexpr std::uint16_t prescaler = 410;  // 410..414: bit-timing registers, no propagation segment
inline constexpr std::uint16_t bit_rate = 416;
inline constexpr std::uint16_t manual_timing = 4416;
inline constexpr std::uint16_t gateway_communication = 4406;
inline constexpr std::uint16_t send_errors = 14401;
inline constexpr std::uint16_t send_status = 14402;
inline constexpr std::uint16_t tpdo_assignment = 16400;  // 16400..16451: TPDO4..16, four words each
inline constexpr std::uint16_t tpdo_cycle = 16460;       // 16460..16472: TPDO4..16
inline constexpr std::uint16_t rpdo_monitoring = 16480;  // 16480..16483: RPDO1..4
inline constexpr std::uint16_t engine_stop = 810;
inline constexpr std::uint16_t first_switch = 811;
inline constexpr std::uint16_t last_switch = 849;
inline constexpr std::uint16_t first_sensor = 900;
inline constexpr std::uint16_t last_sensor = 929;
inline constexpr std::uint16_t type_offset = 4000;  // 8nn → 48nn, 9nn → 49nn
inline constexpr std::uint16_t canopen_type = 3;    // value of 48nn/49nn: comes over CANopen
}  // namespace governor

namespace gateway {
inline constexpr std::uint16_t start_up_delay = 400;
inline constexpr std::uint16_t own_node = 401;
inline constexpr std::uint16_t governor_node = 402;
inline constexpr std::uint16_t hzm_prescaler = 410;  // 410..415
inline constexpr std::uint16_t hzm_bit_rate = 416;
inline constexpr std::uint16_t canopen_prescaler = 420;  // 420..425
inline constexpr std::uint16_t canopen_bit_rate = 426;
inline constexpr std::uint16_t node_id = 427;
inline constexpr std::uint16_t partner_node_id = 428;
inline constexpr std::uint16_t heartbeat_producer = 429;
inline constexpr std::uint16_t heartbeat_consumer = 430;
inline constexpr std::uint16_t governor_communication = 4400;
inline constexpr std::uint16_t hzm_manual_timing = 4416;
inline constexpr std::uint16_t canopen_manual_timing = 4426;
inline constexpr std::uint16_t tpdo_identifier = 16404;  // 16404..16415: TPDO5..16
}  // namespace gateway

// Manufacturer objects of the gateway (manual 5.1).
namespace object {
inline constexpr std::uint16_t errors = 0x2000;  // :1..6 error bits, :7 engine state
inline constexpr std::uint8_t engine_state_sub = 7;
inline constexpr std::uint16_t unsigned_outputs = 0x2001;
inline constexpr std::uint16_t signed_outputs = 0x2002;
inline constexpr std::uint16_t binary_inputs = 0x2003;
inline constexpr std::uint8_t switches_sub = 1;
inline constexpr std::uint8_t sensor_flags_sub = 2;
inline constexpr std::uint16_t sensors = 0x2004;  // sub-index = channel (D26)
}  // namespace object

// Predefined identifiers without the node id (manual 7.2.4, table 4).
inline constexpr std::array<std::uint16_t, 4> tpdo_identifier_bases{0x180, 0x280, 0x380, 0x480};
inline constexpr std::array<std::uint16_t, 4> rpdo_identifier_bases{0x200, 0x300, 0x400, 0x500};

inline constexpr int first_analogue_tpdo = 4;  // TPDO1..3 carry bits
inline constexpr int tpdo_count = 16;
inline constexpr int rpdo_count = 4;
inline constexpr std::uint16_t words_per_pdo = 4;
inline constexpr std::uint32_t longest_time_ms = 65535;  // what the time parameters can hold (D17)

inline constexpr std::uint32_t gateway_main_cycle_us = 16000;  // manual 7.2.3
inline constexpr std::uint32_t maximum_governor_cycles = 255;  // D8
inline constexpr std::uint32_t maximum_heartbeat_cycles = 4095;
inline constexpr std::uint32_t switch_bits = 16;
inline constexpr std::uint32_t sensor_channels = 12;

}  // namespace cgw::config
