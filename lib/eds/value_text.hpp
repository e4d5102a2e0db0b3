// Values of objects as text, the way EDS, DCF and XDD write them, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "dictionary/data_types.hpp"
#include "dictionary/dictionary.hpp"
#include "eds/number.hpp"

namespace cgw::eds {

// Numbers are hexadecimal in the full width of their type (0x04, 0x0006), negative ones decimal,
// values that follow the node number $NODEID+0x180, reals decimal (the bits in hexadecimal where they are no
// finite number), octet strings and domains pairs of hexadecimal digits, other strings as they are. Nothing
// for a structure. An empty string is written as no value is.
std::string value_text(const dictionary::Value& value, const dictionary::TypeRow& type);

// Nothing when the number does not fit into the type. One without sign may use all bits of a signed type:
// 0xFFFF is what many files write for -1.
std::optional<dictionary::Value> value_of(const Number& number, const dictionary::TypeRow& type);

// Nothing when it is too large for a REAL32.
std::optional<dictionary::Value> real_value(double number, const dictionary::TypeRow& type);

// 0 or 0x0, which stand for no data of a domain in many files; 00 is one byte.
bool is_number_zero(std::string_view text);

// The bytes that pairs of hexadecimal digits are, with blanks between them or not; nothing for another text.
std::optional<std::string> octets_of(std::string_view text);

}  // namespace cgw::eds
