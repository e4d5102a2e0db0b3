// How CANopen's things are written for people: one notation in messages, lists, tables and reports.
#pragma once

#include <cstdint>
#include <string>

namespace cgw::base {

// "2003h"; with a sub-index, which is decimal, "2003h:1".
std::string object_text(unsigned index);
std::string object_text(unsigned index, unsigned sub_index);

// "081h", "681h", as the manual prints identifiers (COB-IDs). People type them as 0x681: see
// parameter/value_text.hpp.
std::string identifier_text(std::uint32_t identifier);

// "TPDO5", "RPDO2"
std::string pdo_name(bool is_transmit, unsigned number);

// Microseconds in milliseconds, not rounded: "15.625", and "15.625 ms".
std::string milliseconds(std::uint64_t microseconds);
std::string milliseconds_text(std::uint64_t microseconds);

}  // namespace cgw::base
