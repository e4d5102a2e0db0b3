// The data types of CiA 301 that an object can have: one row each.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "object/vocabulary.hpp"

namespace cgw::dictionary {

// How a value of the type is written and held (dictionary::Value).
enum class TypeKind : std::uint8_t {
    boolean,
    integer,
    natural,  // unsigned
    real,
    visible_string,
    octet_string,
    unicode_string,
    time,  // a number of 48 bits: milliseconds after midnight in the low 28 bits, days above 32 bits
    domain,
    structure,  // a record that CiA 301 lays out; its parts are sub-objects, it has no value itself
};

struct TypeRow {
    object::DataType type;
    std::string_view name;  // as CiA 301 prints it
    TypeKind kind;
    unsigned bits;  // on the wire; 0: as long as the value is
};

// Ascending by number.
std::span<const TypeRow> data_types();

// nullptr for a number that CiA 301 does not give to a type. 24h and above are left to device profiles and
// manufacturers.
const TypeRow* find_type(std::uint64_t number);

const TypeRow& row_of(object::DataType type);

// The value is a number (Value::number), not bytes.
constexpr bool is_numeric(TypeKind kind) {
    return kind <= TypeKind::real || kind == TypeKind::time;
}

}  // namespace cgw::dictionary
