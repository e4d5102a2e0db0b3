// What checks count and repairs state: both by the same functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "eds_check/context.hpp"

namespace cgw::eds_check {

bool is_list_entry(const Context& context, std::uint32_t line);  // 1=0x1000, Line1=…: lists.cpp
std::size_t entries_of(const Context& context, const eds::Section& section);

// Sub-objects that SubNumber counts: all but FFh. sub_objects.cpp
std::size_t sub_objects_of(const Group& group);

// PDOs for NrOfRXPDO and NrOfTXPDO; nothing for other keys. information.cpp
std::optional<std::size_t> described_pdos(const Context& context, std::string_view key);
// A PDO is listed or has a mapping, and its section is missing: then the number may be right.
bool lacks_pdos(const Context& context, std::string_view key);

// What 1018h holds for VendorNumber, ProductNumber, RevisionNumber; nothing where that is not stated.
std::optional<std::uint64_t> identity_number(const Context& context, std::string_view key);
bool is_numbered_from_1(std::string_view key);  // 0 says nothing of the device

}  // namespace cgw::eds_check
