// Values, types and access of objects as they are shown to people and in reports.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "dictionary/dictionary.hpp"

namespace cgw::dictionary {

// A value of that type: "$NODEID+0x180", "0x00000161" in the width of the type, for small types "500
// (0x1F4)",
// "-5", "1.5", "true", "text" in quotes, octets "01 A0 …" as many as fit a line.
std::string value_text(object::DataType type, const Value& value);

// "2001h:1, 16 bits" for an entry of a PDO mapping; "nothing" for 0.
std::string mapping_text(std::uint32_t entry);

// True for 1600h:1.., 1A00h:1..: entries of a PDO mapping.
bool is_mapping_entry(std::uint16_t index, std::uint8_t sub_index);

std::string_view access_text(object::Access access);         // "rww"
std::string_view object_code_text(object::ObjectCode code);  // "RECORD"

}  // namespace cgw::dictionary
