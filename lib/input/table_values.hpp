// One value of a printed table: "1,0" s, "282" Hex, "250".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnostic/rule.hpp"
#include "parameter/row.hpp"

namespace cgw::input {

struct TableValue {
    double value = 0;
    std::string literal;  // the digits as TOML takes them: "1.0", "0x282"
};

struct ValueReading {
    std::optional<TableValue> value;
    const diagnostic::Rule* rule = nullptr;  // why there is none
    std::string message;
    std::string help;
};

// `value` and `unit` are the cells' texts; the unit may stand in the value's cell instead. A decimal comma is
// a point (D12); Hex in the unit, a trailing h or 0x makes hexadecimal digits, which a parameter with a unit
// or one printed in decimal does not have; thousands separators, and decimal digits of a parameter that is
// printed in hexadecimal, are refused as ambiguous (D15). Units are compared and never converted.
ValueReading read_table_value(const parameter::Row& row, std::string_view value, std::string_view unit);

// Begins like a number: a digit, perhaps behind a sign.
bool looks_like_number(std::string_view text);

}  // namespace cgw::input
