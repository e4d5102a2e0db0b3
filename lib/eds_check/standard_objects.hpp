// What CiA 301 fixes of the communication profile: object types and data types, one row each.
#pragma once

#include <cstdint>
#include <optional>

#include "object/vocabulary.hpp"

namespace cgw::eds_check {

// A block of PDO or SDO parameters, or one object.
struct IndexRange {
    std::uint16_t first;
    std::uint16_t last;

    constexpr bool contains(unsigned index) const { return index >= first && index <= last; }
};

inline constexpr IndexRange receive_communication{0x1400, 0x15FF};
inline constexpr IndexRange receive_mapping{0x1600, 0x17FF};
inline constexpr IndexRange transmit_communication{0x1800, 0x19FF};
inline constexpr IndexRange transmit_mapping{0x1A00, 0x1BFF};
inline constexpr IndexRange sdo_servers{0x1200, 0x127F};
inline constexpr IndexRange sdo_clients{0x1280, 0x12FF};

// Nothing where it is not fixed, or where real devices do both.
std::optional<object::ObjectCode> standard_code(std::uint16_t index);
std::optional<object::DataType> standard_type(std::uint16_t index, std::uint8_t sub_index);

// standard_type() speaks of sub-objects of this object.
bool is_parent_by_standard(std::uint16_t index);

// Sub-object 0 says how many entries are in use, not which is the highest.
constexpr bool counts_entries_in_use(std::uint16_t index) {
    constexpr std::uint16_t error_field = 0x1003;
    return index == error_field || receive_mapping.contains(index) || transmit_mapping.contains(index);
}

}  // namespace cgw::eds_check
