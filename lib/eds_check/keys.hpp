// The keys that CiA 306 gives to each kind of section: one row each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "eds/section_names.hpp"

namespace cgw::eds_check {

enum class Tail : std::uint8_t { none, number, type_number };  // behind the name: nothing, 17, 0006

enum class Holds : std::uint8_t { number, text, value };  // value: of the data type of its object

struct KeyRow {
    eds::SectionKind kind;  // of objects: `object`, also for sub-objects
    std::string_view name;
    Holds holds = Holds::number;
    Tail tail = Tail::none;
    bool required = false;  // by whoever reads the file; of objects other rules say so
};

inline constexpr std::array object_lists{eds::SectionKind::mandatory_objects,
                                         eds::SectionKind::optional_objects,
                                         eds::SectionKind::manufacturer_objects};

std::span<const KeyRow> rows_of(eds::SectionKind kind);  // empty: any key may stand there

// nullptr when the section has no such key; case does not matter.
const KeyRow* find_key(eds::SectionKind kind, std::string_view key);

// The spelling of CiA 306 for a key that the row is of: with its tail as it stands there.
bool is_spelt_as(const KeyRow& row, std::string_view key);

}  // namespace cgw::eds_check
