// The parameter numbers the CANopen side reads by name. Ranges and texts stand in the catalogues.
#pragma once

#include <cstdint>

#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"

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
// 16400..16451: TPDO4..16, four words each
inline constexpr std::uint16_t tpdo_assignment = 16400;
inline constexpr std::uint16_t last_tpdo_assignment = tpdo_assignment + facts::maximum_outputs - 1;
constexpr std::uint16_t tpdo_assignment_of(int tpdo, int word) {  // 1..4
    return static_cast<std::uint16_t>(tpdo_assignment +
                                      facts::words_per_pdo * (tpdo - facts::first_analogue_tpdo) + word - 1);
}
// 16460..16472: TPDO4..16
inline constexpr std::uint16_t tpdo_cycle = 16460;
inline constexpr std::uint16_t last_tpdo_cycle = tpdo_cycle + facts::analogue_tpdos - 1;
constexpr std::uint16_t tpdo_cycle_of(int tpdo) {
    return static_cast<std::uint16_t>(tpdo_cycle + tpdo - facts::first_analogue_tpdo);
}
// 16480..16483: RPDO1..4
inline constexpr std::uint16_t rpdo_monitoring = 16480;
inline constexpr std::uint16_t last_rpdo_monitoring = rpdo_monitoring + facts::rpdo_count - 1;
constexpr std::uint16_t rpdo_monitoring_of(int rpdo) {
    return static_cast<std::uint16_t>(rpdo_monitoring + rpdo - 1);
}
constexpr int rpdo_of_monitoring(std::uint16_t number) {
    return number - rpdo_monitoring + 1;
}
inline constexpr std::uint16_t engine_stop = 810;
inline constexpr std::uint16_t first_switch = 811;
inline constexpr std::uint16_t last_switch = 849;
using facts::first_sensor;
using facts::last_sensor;
inline constexpr std::uint16_t canopen_type = 3;             // value of 48nn/49nn: comes over CANopen
constexpr std::uint16_t type_of(std::uint16_t assignment) {  // 8nn → 48nn, 9nn → 49nn
    return static_cast<std::uint16_t>(assignment + facts::assignment_to_type);
}
constexpr std::uint16_t assignment_of(std::uint16_t type) {
    return static_cast<std::uint16_t>(type - facts::assignment_to_type);
}
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
// 16404..16415: TPDO5..16
inline constexpr int first_tpdo_of_own_identifier = facts::predefined_pdos + 1;
inline constexpr std::uint16_t tpdo_identifier = 16404;
constexpr std::uint16_t tpdo_identifier_of(int tpdo) {
    return static_cast<std::uint16_t>(tpdo_identifier + tpdo - first_tpdo_of_own_identifier);
}
inline constexpr std::uint16_t last_tpdo_identifier = tpdo_identifier_of(facts::tpdo_count);
}  // namespace gateway

inline constexpr std::uint32_t longest_time_ms = 65535;  // what the time parameters can hold (D17)

// The device's own facts, under this room's names.
namespace object = facts::object;
using facts::first_analogue_tpdo;
using facts::gateway_main_cycle_us;
using facts::maximum_governor_cycles;
using facts::maximum_heartbeat_cycles;
using facts::rpdo_count;
using facts::sensor_channels;
using facts::switch_bits;
using facts::tpdo_count;
using facts::words_per_pdo;
inline constexpr auto& tpdo_identifier_bases = facts::cob::tpdo;  // GWM 7.2.4, table 4
inline constexpr auto& rpdo_identifier_bases = facts::cob::rpdo;

}  // namespace cgw::config
