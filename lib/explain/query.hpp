// How a question to `cgw explain` is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cgw::explain {

// "2005h", "0x2005", "2000h:1", "0x2000:0x01", and as the manual prints it "2000h01".
struct ObjectName {
    std::uint16_t index = 0;
    std::optional<std::uint8_t> sub;
};

std::optional<ObjectName> parse_object(std::string_view text);

// "0x06010002", "06010002h", "0601 0002h"
std::optional<std::uint32_t> parse_abort_code(std::string_view text);

// A parameter's number: decimal digits only, 0..65535.
std::optional<std::uint16_t> parse_parameter_number(std::string_view text);

// A whole number as the command line takes it: "9", "0x0102", "102h", 0..FFFFFFFFh; no sign, no separators.
std::optional<std::uint32_t> parse_number(std::string_view text);

// The value of a question "3800=9": such a number, or "0b101".
std::optional<std::uint32_t> parse_value(std::string_view text);

// The same, and what parameters take beyond it: -5, 1.5, 1,5 (D12).
std::optional<double> parse_parameter_value(std::string_view text);

}  // namespace cgw::explain
