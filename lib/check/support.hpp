// What the checks share: values that may be relied on, and how messages name things.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/canopen_text.hpp"
#include "check/checks.hpp"

namespace cgw::check {

using base::identifier_text;
using base::milliseconds_text;

// The assignment, or nullptr when the number is not set or its value does not fit its row (the input has
// reported that).
const parameter::Assignment* usable(const Context& context, parameter::Device device, std::uint16_t number);

// usable(), and no error stands at the value: warnings and notes have nothing to add to an error.
const parameter::Assignment* sound(const Context& context, parameter::Device device, std::uint16_t number);

// True where a check may say that the parameter is absent: not set, not refused by the input, and its
// table stands in the file.
bool absent(const Context& context, parameter::Device device, std::uint16_t number);

// True where a check may say that the parameter is 0, typed or by default.
bool is_off(const Context& context, parameter::Device device, std::uint16_t number);

// "0" or "not set", for a parameter that is off.
std::string_view off_text(const Context& context, parameter::Device device, std::uint16_t number);

// The value, or the header of its table when it is not set.
const diagnostic::Location& place_of(const Context& context, parameter::Device device, std::uint16_t number);

// The header [governor.parameters] or [gateway.parameters].
const diagnostic::Location& table_of(const Context& context, parameter::Device device);

// "402 CanDCNodeNumber"
std::string label(const Context& context, parameter::Device device, std::uint16_t number);

// "the gateway's 402 CanDCNodeNumber"
std::string owned_label(const Context& context, parameter::Device device, std::uint16_t number);

// "100 ms", "250 kbit/s", "3", "0x282"
std::string quantity(const parameter::Assignment& assignment);

// A decimal literal for a parameter that the manual prints in hexadecimal (D15), with two readings.
// Defined with the check about it, in spelling.cpp.
bool decimal_in_doubt(const parameter::Assignment& assignment);

// "the gateway's 402 CanDCNodeNumber is 2 here", pointing at the value.
diagnostic::Related here(const parameter::Assignment& assignment);

}  // namespace cgw::check
