// What the checks share: values that may be relied on, and how messages name things.
#pragma once

#include <cstdint>
#include <string>

#include "check/checks.hpp"

namespace cgw::check {

// The assignment, or nullptr when the number is not set or its value does not fit its row (the input has
// reported that).
const parameter::Assignment* usable(const Context& context, parameter::Device device, std::uint16_t number);

// True where a check may say that the parameter is absent: not set, not refused by the input, and its
// table stands in the file.
bool absent(const Context& context, parameter::Device device, std::uint16_t number);

// The header [governor.parameters] or [gateway.parameters].
const diagnostic::Location& table_of(const Context& context, parameter::Device device);

// "402 CanDCNodeNumber"
std::string label(const Context& context, parameter::Device device, std::uint16_t number);

// "the gateway's 402 CanDCNodeNumber"
std::string owned_label(const Context& context, parameter::Device device, std::uint16_t number);

// "100 ms", "250 kbit/s", "3"
std::string quantity(const parameter::Assignment& assignment);

// "282h", as the manual prints identifiers
std::string identifier_text(std::uint32_t identifier);

// "the gateway's 402 CanDCNodeNumber is 2 here", pointing at the value.
diagnostic::Related here(const parameter::Assignment& assignment);

}  // namespace cgw::check
