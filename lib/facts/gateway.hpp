// What holds for every CANopen Gateway, however it is configured (GWM 4, 5, 7).
#pragma once

#include <array>
#include <cstdint>

namespace cgw::facts {

// Manufacturer objects (GWM 5.1); those of the communication profile are in communication.hpp.
namespace object {
inline constexpr std::uint16_t unsigned16_dummy = 0x0006;  // D25
inline constexpr std::uint16_t errors = 0x2000;            // :1..6 error bits, :7 engine state (D20)
inline constexpr std::uint8_t engine_state_sub = 7;
inline constexpr std::uint16_t unsigned_outputs = 0x2001;  // D24
inline constexpr std::uint16_t signed_outputs = 0x2002;
inline constexpr std::uint16_t binary_inputs = 0x2003;  // D25
inline constexpr std::uint8_t switches_sub = 1;
inline constexpr std::uint8_t sensor_flags_sub = 2;
inline constexpr std::uint16_t sensors = 0x2004;  // sub-index = channel (D26)
inline constexpr std::uint16_t canopen_errors = 0x2005;
}  // namespace object

// 1018h:1 and :2 (GWM 10).
inline constexpr std::uint32_t vendor_number = 0x161;
inline constexpr std::uint32_t product_number = 0x1B59;

inline constexpr std::uint8_t tpdo_count = 16;
inline constexpr std::uint8_t rpdo_count = 4;
inline constexpr std::uint8_t pdo_count = tpdo_count + rpdo_count;
inline constexpr std::uint8_t predefined_pdos = 4;      // TPDO1..4 and RPDO1..4 follow the node number
inline constexpr std::uint8_t first_analogue_tpdo = 4;  // TPDO1..3 carry bits and have no cycle
inline constexpr std::uint8_t binary_tpdos = first_analogue_tpdo - 1;
inline constexpr std::uint8_t analogue_tpdos = tpdo_count - binary_tpdos;
inline constexpr std::uint8_t words_per_pdo = 4;
inline constexpr std::uint8_t maximum_outputs = analogue_tpdos * words_per_pdo;  // of 2001h and 2002h (D24)
inline constexpr std::uint8_t word_bits = 16;
inline constexpr std::uint8_t word_bytes = 2;
inline constexpr std::uint8_t transmission_type = 254;  // D31

// Error bits: 2000h:1..6 in order; bit b (0..95) is error 3000 + b [inference] (D21).
inline constexpr std::uint8_t error_words = 6;
inline constexpr std::uint8_t error_bits = error_words * word_bits;
inline constexpr std::uint16_t first_error_number = 3000;
inline constexpr std::uint16_t last_error_number = first_error_number + error_bits - 1;
constexpr std::uint16_t error_number(unsigned bit) {
    return static_cast<std::uint16_t>(first_error_number + bit);
}
constexpr bool is_error_number(unsigned number) {
    return number >= first_error_number && number <= last_error_number;
}

// 2005h: bit = number - 12411 (D52).
inline constexpr std::uint16_t first_canopen_error = 12411;
inline constexpr std::uint16_t last_canopen_error = 12424;

// Sensor 9nn is shown by measurement 29nn and has its scaling [inference] (D38).
inline constexpr std::uint16_t first_sensor = 900;
inline constexpr std::uint16_t last_sensor = 929;
inline constexpr std::uint16_t sensor_to_measurement = 2000;
constexpr bool is_sensor(std::uint16_t number) {
    return number >= first_sensor && number <= last_sensor;
}
constexpr std::uint16_t measurement_of(std::uint16_t sensor) {
    return static_cast<std::uint16_t>(sensor + sensor_to_measurement);
}

// A switch function 8nn or sensor 9nn has its type in 48nn or 49nn (D27).
inline constexpr std::uint16_t assignment_to_type = 4000;

// RPDO1 word 1 carries switch functions in 16 bits, word 3 an error flag for each sensor channel (D25).
inline constexpr std::uint8_t switch_bits = 16;
inline constexpr std::uint8_t sensor_channels = 12;
// Channel c (1..12) is word (c - 1) mod 4 + 1 of RPDO 2 + (c - 1) / 4 (D26).
constexpr std::uint8_t rpdo_of_channel(unsigned channel) {
    return static_cast<std::uint8_t>(2 + (channel - 1) / words_per_pdo);
}
constexpr std::uint8_t word_of_channel(unsigned channel) {
    return static_cast<std::uint8_t>((channel - 1) % words_per_pdo + 1);
}
constexpr int first_channel_of_rpdo(int rpdo) {  // RPDO2..4
    return (rpdo - 2) * words_per_pdo + 1;
}
constexpr int last_channel_of_rpdo(int rpdo) {
    return first_channel_of_rpdo(rpdo) + words_per_pdo - 1;
}

// Bit rates of 416 and 426 (D6).
inline constexpr std::array<std::uint16_t, 4> bit_rates_kbit{125, 250, 500, 1000};
inline constexpr std::uint8_t maximum_hzm_node = 31;  // D4

// Times become whole main cycles: floor, at least one, 0 is off (D8). In 32 bits, as a small controller
// divides; what does not fit, over 71 minutes, is more cycles than anything takes.
inline constexpr std::uint32_t gateway_main_cycle_us = 16'000;         // GWM 7.2.3
inline constexpr std::uint32_t usual_governor_main_cycle_us = 15'625;  // where nothing else is said
inline constexpr std::uint32_t maximum_governor_cycles = 255;
inline constexpr std::uint32_t maximum_heartbeat_cycles = 4095;
constexpr std::uint32_t whole_cycles(std::uint32_t asked_ms, std::uint32_t main_cycle_us) {
    if (asked_ms == 0 || main_cycle_us == 0) {
        return 0;
    }
    if (asked_ms > ~std::uint32_t{0} / 1000) {
        return ~std::uint32_t{0};
    }
    const std::uint32_t whole = asked_ms * 1000 / main_cycle_us;
    return whole == 0 ? 1 : whole;
}

}  // namespace cgw::facts
