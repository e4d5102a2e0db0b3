// The frames of a plant and what is in them, as plain data: the one place that says which bit of which PDO
// means what. CAN database, layouts, encoding, decoding and generated code are made from it. Everything is
// copied: nothing refers to the settings or the catalogue it was made from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/configuration.hpp"
#include "parameter/row.hpp"

namespace cgw::signals {

enum class Kind : std::uint8_t {
    error,            // one error bit of 2000h:1..6 (D21, D58)
    engine_state,     // one bit of 2000h:7 (D22)
    measurement,      // a word of 2001h or 2002h (D24)
    switch_function,  // one bit of 2003h:1 (D25)
    sensor_flag,      // one bit of 2003h:2 (D25)
    sensor,           // a word of 2004h (D26)
};

// "error", "engine-state", "measurement", "switch", "sensor-flag", "sensor"
std::string_view to_text(Kind kind);

// A parameter that stands behind a signal.
struct Source {
    parameter::Device device = parameter::Device::governor;
    std::uint16_t number = 0;
    std::string name;         // as the catalogue has it; "" where the manuals name none
    bool low_active = false;  // switch function: it is on while the bit is 0

    std::string label() const;  // "2000 Speed", or the number alone
};

struct NamedValue {
    std::int32_t raw = 0;
    std::string text;
};

// Physical value = raw * factor + offset. A single bit has factor 1, offset 0, range 0..1 and no unit.
struct Signal {
    Kind kind = Kind::measurement;
    std::string name;  // unique in its frame, case ignored: letters, digits, _, no digit first, 1..32 long
    unsigned first_bit = 0;  // 0..63, of the least significant bit; bit 0 is the lowest of byte 0
    unsigned width = 16;     // bits: 1, or 16 from a byte boundary on, low byte first
    bool is_signed = false;  // two's complement

    std::uint16_t index = 0;      // object that the word comes from or goes to
    std::uint8_t sub_index = 0;   //
    std::uint8_t object_bit = 0;  // of a single bit: 0..15, 0 the lowest of the object
    std::uint8_t channel = 0;     // sensor and its flag: 1..12, else 0
    std::uint16_t number =
        0;  // parameter it shows or sets; an error has one even where it has no name; 0: none
    std::vector<Source> sources{};    // error: the devices that name it; functions or sensors that share it
    std::vector<Source> scaled_as{};  // at most one: the measurement whose scaling a sensor has (D38)

    bool scaled = false;  // false: factor 1, offset 0, the range is that of the raw number, no unit
    double factor = 1;    // never 0; negative on a falling line
    double offset = 0;
    std::int32_t raw_minimum = 0;  // range of raw values that mean something (internal range); others can be
    std::int32_t raw_maximum = 0;  // on the wire: width and sign decide
    double minimum = 0;            // the same range in physical values, minimum <= maximum
    double maximum = 0;
    std::string unit{};                // UTF-8; "" for none
    std::vector<NamedValue> values{};  // "on" and "off" of a switch; empty where functions on a bit disagree

    bool is_bit() const { return width == 1; }
    bool is_error_flag() const { return kind == Kind::error || kind == Kind::sensor_flag; }
};

// A mapped word as the PDO's mapping has it, with or without signals.
struct Word {
    config::WordKind kind = config::WordKind::dummy;
    std::uint16_t index = 0;  // 0006h for a dummy
    std::uint8_t sub_index = 0;
};

struct Frame {
    std::string name;                                           // "TPDO4"
    config::Direction direction = config::Direction::transmit;  // as the gateway sees it
    std::uint8_t number = 0;                                    // TPDO 1..16, RPDO 1..4
    std::uint16_t identifier = 0;                               // COB-ID, 11 bits
    std::uint8_t length = 0;                                    // bytes, 2..8
    std::uint32_t period_us = 0;      // transmit: time between two frames; 0: sent when a bit changes
    std::uint32_t monitoring_us = 0;  // receive: longest time between two frames; 0: not monitored
    std::uint16_t communication = 0;  // objects: 1803h
    std::uint16_t mapping = 0;        // 1A03h
    std::vector<Word> words{};        // 1..4; word n is bytes 2n - 2 and 2n - 1
    std::vector<Signal> signals{};    // ascending first bit; bits without one mean nothing

    bool transmit() const { return direction == config::Direction::transmit; }
};

// The active PDOs, TPDO1..16 and then RPDO1..4.
std::vector<Frame> frames_of(const parameter::Settings& settings, const parameter::Catalogue& catalogue,
                             const config::Configuration& configuration);

}  // namespace cgw::signals
