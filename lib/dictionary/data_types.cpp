#include "dictionary/data_types.hpp"

#include <array>

namespace cgw::dictionary {
namespace {

using object::DataType;

constexpr std::array table{
    TypeRow{DataType::boolean, "BOOLEAN", TypeKind::boolean, 1},
    TypeRow{DataType::integer8, "INTEGER8", TypeKind::integer, 8},
    TypeRow{DataType::integer16, "INTEGER16", TypeKind::integer, 16},
    TypeRow{DataType::integer32, "INTEGER32", TypeKind::integer, 32},
    TypeRow{DataType::unsigned8, "UNSIGNED8", TypeKind::natural, 8},
    TypeRow{DataType::unsigned16, "UNSIGNED16", TypeKind::natural, 16},
    TypeRow{DataType::unsigned32, "UNSIGNED32", TypeKind::natural, 32},
    TypeRow{DataType::real32, "REAL32", TypeKind::real, 32},
    TypeRow{DataType::visible_string, "VISIBLE_STRING", TypeKind::visible_string, 0},
    TypeRow{DataType::octet_string, "OCTET_STRING", TypeKind::octet_string, 0},
    TypeRow{DataType::unicode_string, "UNICODE_STRING", TypeKind::unicode_string, 0},
    TypeRow{DataType::time_of_day, "TIME_OF_DAY", TypeKind::time, 48},
    TypeRow{DataType::time_difference, "TIME_DIFFERENCE", TypeKind::time, 48},
    TypeRow{DataType::domain, "DOMAIN", TypeKind::domain, 0},
    TypeRow{DataType::integer24, "INTEGER24", TypeKind::integer, 24},
    TypeRow{DataType::real64, "REAL64", TypeKind::real, 64},
    TypeRow{DataType::integer40, "INTEGER40", TypeKind::integer, 40},
    TypeRow{DataType::integer48, "INTEGER48", TypeKind::integer, 48},
    TypeRow{DataType::integer56, "INTEGER56", TypeKind::integer, 56},
    TypeRow{DataType::integer64, "INTEGER64", TypeKind::integer, 64},
    TypeRow{DataType::unsigned24, "UNSIGNED24", TypeKind::natural, 24},
    TypeRow{DataType::unsigned40, "UNSIGNED40", TypeKind::natural, 40},
    TypeRow{DataType::unsigned48, "UNSIGNED48", TypeKind::natural, 48},
    TypeRow{DataType::unsigned56, "UNSIGNED56", TypeKind::natural, 56},
    TypeRow{DataType::unsigned64, "UNSIGNED64", TypeKind::natural, 64},
    TypeRow{DataType::pdo_communication, "PDO_COMMUNICATION_PARAMETER", TypeKind::structure, 0},
    TypeRow{DataType::pdo_mapping, "PDO_MAPPING", TypeKind::structure, 0},
    TypeRow{DataType::sdo_parameter, "SDO_PARAMETER", TypeKind::structure, 0},
    TypeRow{DataType::identity, "IDENTITY", TypeKind::structure, 0},
};

constexpr std::size_t highest = static_cast<std::size_t>(table.back().type);

// Position of a number's row, plus 1; 0: none.
constexpr auto positions = [] {
    std::array<std::uint8_t, highest + 1> result{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        result[static_cast<std::size_t>(table[i].type)] = static_cast<std::uint8_t>(i + 1);
    }
    return result;
}();

}  // namespace

std::span<const TypeRow> data_types() {
    return table;
}

const TypeRow* find_type(std::uint64_t number) {
    return number <= highest && positions[number] != 0 ? &table[positions[number] - 1U] : nullptr;
}

const TypeRow& row_of(object::DataType type) {
    return *find_type(static_cast<std::uint64_t>(type));
}

}  // namespace cgw::dictionary
