// A parameter as the catalogue describes it: one row per number, array elements included.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cgw::parameter {

// The two devices that one parameter file configures. Numbers mean different things in each (D1).
enum class Device : std::uint8_t { governor, gateway };

std::string_view to_text(Device device);  // "governor", "gateway": also the file's table names

// A device runs its bootloader first and its application after that; one number may mean different things in
// the two (D1): 3076 is ErrEEPROM in the gateway's bootloader and ErrParamStore in its application.
enum class Program : std::uint8_t { application, bootloader };

std::string_view to_text(Program program);  // "application", "bootloader"

// The manual's chapter 11 lists, in its order.
enum class List : std::uint8_t { parameter, measurement, function, curve };

// What a row means to the CANopen side; derived numbers (8nn ↔ 48nn, 9nn ↔ 49nn) differ by 4000.
enum class Role : std::uint8_t { none, switch_assignment, switch_type, sensor_assignment, sensor_type };

enum class Base : std::uint8_t { decimal, hexadecimal };

// One bit of a value. Bit 0 is the least significant one.
struct NamedBit {
    std::uint8_t bit = 0;
    std::string_view name{};  // fit for a signal name: "Node1"
    std::string_view text{};  // what it means when it is set
};

// One value that the manual gives a meaning of its own: 3800 = 9.
struct NamedValue {
    std::uint32_t value = 0;
    std::string_view text{};
};

// The linear relation between the word on the wire and engineering units. The external limits are
// constants or, where the governor makes them settable, other parameters (978..995).
struct Scaling {
    std::int32_t internal_minimum = 0;
    std::int32_t internal_maximum = 0;
    std::optional<double> external_minimum{};
    std::optional<double> external_maximum{};
    std::uint16_t external_minimum_parameter = 0;  // 0: the constant holds
    std::uint16_t external_maximum_parameter = 0;
};

struct Row {
    Device device = Device::governor;
    Program program = Program::application;
    std::uint16_t number = 0;
    std::string_view name{};                        // canonical; "" where the manuals name none (D13)
    std::span<const std::string_view> aliases{};    // accepted without noise (D3)
    std::span<const std::string_view> misprints{};  // "409 CanBaudrate": accepted with a note (D2, D10)
    List list = List::parameter;
    Role role = Role::none;
    std::uint8_t level = 0;  // user level 1..7; 0: not printed
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    std::span<const std::uint32_t> choices{};  // exactly these values, when not empty (D6)
    std::string_view unit{};                   // "s", "ms", "kbit/s", "1/min", …; "" for none
    Base base = Base::decimal;                 // as the manual prints values
    bool decimal = false;                      // takes fractions; integers only otherwise
    std::uint16_t array_first = 0;             // number of element (0); 0: not an array element
    std::uint16_t array_size = 0;
    std::uint16_t list_end = 0;  // last number a list starting here may reach
    std::uint8_t width = 0;      // bits of a measurement: 1, 8, 16; 0: not known
    bool is_signed = false;
    std::optional<Scaling> scaling{};
    std::span<const NamedBit> bits{};      // ascending; a bit without a row has no known meaning
    std::span<const NamedValue> values{};  // ascending
    std::string_view text{};               // one line, our own words
    std::string_view used{};               // the object or PDO word it feeds: "1804h:1, the COB-ID of TPDO5"
    std::string_view section{};            // "GWM 7.2.4"
    std::span<const std::uint32_t> pages{};  // of the manual, as its list prints them

    bool has_range() const { return minimum || maximum || !choices.empty(); }
    // Whether the parameter can have this value: one of the choices, or a finite number within the limits.
    bool allows(double value) const;
    bool settable() const { return list != List::measurement; }
    bool is_bit() const { return width == 1; }
    std::uint16_t array_index() const { return static_cast<std::uint16_t>(number - array_first); }
};

// `16404 CanOpTPDO5-16ID(0)`, or the bare number of a row without a name.
std::string label(const Row& row);

// Raw value to engineering units along the line through (internal_minimum, external_minimum) and
// (internal_maximum, external_maximum). `raw` is the word as the wire carries it, sign applied. The internal
// limits must differ. See settings.hpp for the limits that hold in a given parameter set.
double to_engineering(std::int32_t raw, std::int32_t internal_minimum, std::int32_t internal_maximum,
                      double external_minimum, double external_maximum);

}  // namespace cgw::parameter
