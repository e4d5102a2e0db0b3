// The resolved configuration: what the two devices will do with the settings. Plain data, no text.
// Resolution never fails: wrong settings give a configuration that the checks then refuse.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/canopen_text.hpp"
#include "bit_timing/timing.hpp"
#include "facts/gateway.hpp"
#include "parameter/row.hpp"
#include "parameter/settings.hpp"

namespace cgw::config {

// D8: a time in ms becomes whole main cycles. All zero: off.
struct CyclicTime {
    std::uint32_t asked_ms = 0;
    std::uint32_t cycles = 0;
    std::uint32_t effective_us = 0;  // cycles × main cycle

    std::uint32_t effective_ms() const { return effective_us / 1000; }  // floored, as objects carry it (D31)
};

CyclicTime cyclic_time(std::uint32_t asked_ms, std::uint32_t main_cycle_us);

// Register values as typed (D7): value − 1 of the quantity.
struct BusTiming {
    bool manual = false;              // 4416 / 4426
    std::uint16_t bit_rate_kbit = 0;  // 125, 250, 500, 1000; meaningless when manual
    std::uint8_t prescaler = 0;
    std::uint8_t sync_jump_width = 0;
    std::uint8_t sampling_mode = 0;
    std::uint8_t phase_segment_1 = 0;
    std::uint8_t phase_segment_2 = 0;
    std::uint8_t prop_segment = 0;  // 0 in the governor, which has none
};

// The registers with their clock and controller; nullopt where timing is not manual, or the parameter file
// tells neither (D7).
std::optional<bit_timing::Timing> timing_by_hand(const BusTiming& timing,
                                                 const std::optional<parameter::BitTiming>& controller);

// Bits per second: as set, or from registers, clock and controller family (D7), rounded. nullopt where the
// timing is manual and the parameter file tells no clock.
std::optional<std::uint32_t> bit_rate(const BusTiming& timing,
                                      const std::optional<parameter::BitTiming>& controller);

enum class Direction : std::uint8_t { transmit, receive };
enum class CobIdSource : std::uint8_t { predefined, parameter };

enum class WordKind : std::uint8_t {
    dummy,         // 0006h, receive only
    errors,        // 2000h:1..6, error bits
    engine_state,  // 2000h:7
    measurement,   // 2001h / 2002h
    switches,      // 2003h:1
    sensor_flags,  // 2003h:2
    sensor,        // 2004h
};

struct MappedWord {
    WordKind kind = WordKind::dummy;
    std::uint16_t index = 0;  // object; 0006h for a dummy
    std::uint8_t sub_index = 0;
    const parameter::Row* parameter = nullptr;  // measurement: its row; sensor: the 9nn row; else null
};

inline constexpr std::uint16_t dummy_index = facts::object::unsigned16_dummy;  // D25
using facts::transmission_type;
using facts::word_bits;

struct Pdo {
    Direction direction = Direction::transmit;
    std::uint8_t number = 0;  // TPDO 1..16, RPDO 1..4
    bool active = false;
    std::uint16_t cob_id = 0;  // 11 bits; kept when inactive; 0: not set
    CobIdSource cob_id_source = CobIdSource::predefined;
    CyclicTime time;                  // cycle (TPDO4..16) or monitoring (RPDO); zero for TPDO1..3
    std::vector<MappedWord> mapping;  // empty when inactive

    std::string name() const { return base::pdo_name(direction == Direction::transmit, number); }
    std::uint8_t length() const {
        return static_cast<std::uint8_t>(facts::word_bytes * mapping.size());
    }  // bytes
};

// A switch function carried by RPDO1 word 1 (D27): type 3 and a bit number in ±1..16.
struct SwitchFunction {
    const parameter::Row* row = nullptr;  // 8nn
    std::uint8_t bit = 0;                 // 1..16
    bool low_active = false;
};

// A sensor carried by RPDO2..4: type 3 and a channel in 1..12.
struct Sensor {
    const parameter::Row* row = nullptr;  // 9nn
    std::uint8_t channel = 0;
};

// An object that exists because of the configuration: 2001h/2002h entries in D24's order.
struct AnalogueOutput {
    const parameter::Row* parameter = nullptr;
    std::uint16_t index = 0;  // 2001h unsigned, 2002h signed
    std::uint8_t sub_index = 0;
    std::uint8_t tpdo = 0;  // 4..16
    std::uint8_t word = 0;  // 1..4, as sent
};

enum class DecisionKind : std::uint8_t {
    dropped,    // an assignment of 0, unknown or bit parameter inside a TPDO closes up
    moved,      // a word that therefore stands earlier than it was typed
    quantised,  // a time that becomes whole main cycles
};

// What the devices make of a setting, for notes and reports.
struct Decision {
    DecisionKind kind = DecisionKind::dropped;
    parameter::Device device = parameter::Device::governor;
    std::uint16_t parameter = 0;   // the setting concerned
    std::uint8_t pdo = 0;          // TPDO/RPDO number, 0 for heartbeat
    std::uint8_t asked_word = 0;   // moved, dropped: 1..4 as typed
    std::uint8_t actual_word = 0;  // moved: 1..4 as sent
    CyclicTime time{};             // quantised
};

struct Configuration {
    // CAN1, HEINZMANN side
    std::uint8_t governor_node = 0;             // governor 401
    std::uint8_t gateway_node_in_governor = 0;  // governor 403
    std::uint8_t gateway_node = 0;              // gateway 401
    std::uint8_t governor_node_in_gateway = 0;  // gateway 402
    std::uint32_t governor_start_up_delay_ms = 0;
    std::uint32_t gateway_start_up_delay_ms = 0;
    std::uint32_t main_cycle_us = facts::usual_governor_main_cycle_us;
    BusTiming governor_can;
    BusTiming can1;

    // CAN2, CANopen side
    BusTiming can2;
    std::uint8_t node_id = 0;
    std::uint8_t partner_node_id = 0;  // 0: none (D14)
    CyclicTime heartbeat_producer;
    CyclicTime heartbeat_consumer;
    parameter::Identity identity;

    bool send_errors = false;                // TPDO1 and 2
    bool send_status = false;                // TPDO3
    std::array<Pdo, facts::pdo_count> pdos;  // TPDO1..16, RPDO1..4
    std::vector<AnalogueOutput> analogue_outputs;
    std::vector<SwitchFunction> switches;  // ascending number
    std::vector<Sensor> sensors;           // ascending number
    std::uint8_t highest_channel = 0;      // 2004h sub 0 (D26)
    bool switches_object = false;          // 2003h:1 exists (D25)
    bool sensor_flags_object = false;      // 2003h:2 exists

    std::vector<Decision> decisions;

    const Pdo& tpdo(int number) const { return pdos[static_cast<std::size_t>(number - 1)]; }
    const Pdo& rpdo(int number) const {
        return pdos[static_cast<std::size_t>(facts::tpdo_count + number - 1)];
    }
};

Configuration resolve(const parameter::Settings& settings, const parameter::Catalogue& catalogue);

// Row carried by a TPDO word: known to the catalogue, of known width, not a bit (D13).
bool transmittable(const parameter::Row* row);

// Row whose scaling a carried word has: its own, or for a sensor 9nn without one that of 29nn (D38).
const parameter::Row& scaling_row(const parameter::Row& row, const parameter::Catalogue& catalogue);

}  // namespace cgw::config
