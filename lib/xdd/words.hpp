// Words of CiA 311 that reader and writer share: one row each.
#pragma once

#include <array>
#include <string_view>

#include "object/vocabulary.hpp"

namespace cgw::xdd {

inline constexpr std::string_view name_space = "http://www.canopen.org/xml/1.1";

// A data type of IEC 61131-3, as an element of a parameter.
struct ElementaryType {
    std::string_view element;
    object::DataType type;
};

// The first row of a type is how it is written. BITSTRING, which has no width, stands for all types without a
// row: there the dataType of the object says which.
inline constexpr std::array elementary_types{
    ElementaryType{"BOOL", object::DataType::boolean},
    ElementaryType{"SINT", object::DataType::integer8},
    ElementaryType{"INT", object::DataType::integer16},
    ElementaryType{"DINT", object::DataType::integer32},
    ElementaryType{"LINT", object::DataType::integer64},
    ElementaryType{"USINT", object::DataType::unsigned8},
    ElementaryType{"UINT", object::DataType::unsigned16},
    ElementaryType{"UDINT", object::DataType::unsigned32},
    ElementaryType{"ULINT", object::DataType::unsigned64},
    ElementaryType{"REAL", object::DataType::real32},
    ElementaryType{"LREAL", object::DataType::real64},
    ElementaryType{"STRING", object::DataType::visible_string},
    ElementaryType{"WSTRING", object::DataType::unicode_string},
    ElementaryType{"CHAR", object::DataType::integer8},
    ElementaryType{"BYTE", object::DataType::unsigned8},
    ElementaryType{"WORD", object::DataType::unsigned16},
    ElementaryType{"DWORD", object::DataType::unsigned32},
    ElementaryType{"LWORD", object::DataType::unsigned64},
};
inline constexpr std::string_view type_without_width = "BITSTRING";

// By object::Access: accessType of an object, access of a parameter. The object has no words for rwr and rww.
struct AccessWords {
    std::string_view object;
    std::string_view parameter;
};
inline constexpr std::array<AccessWords, 6> access_words{
    AccessWords{"ro", "read"},           AccessWords{"wo", "write"},           AccessWords{"rw", "readWrite"},
    AccessWords{"rw", "readWriteInput"}, AccessWords{"rw", "readWriteOutput"}, AccessWords{"const", "const"}};

// PDOmapping of an object that can be mapped, by object::Access: into a TPDO, an RPDO or either.
inline constexpr std::array<std::string_view, 6> mapping_words{"TPDO", "RPDO", "optional",
                                                               "TPDO", "RPDO", "TPDO"};

// How a bit rate ends, behind its number of kbit/s.
inline constexpr std::string_view bit_rate_unit = " Kbps";

inline constexpr unsigned dummy_types = 7;  // Dummy0001..Dummy0007

// What stands for "not known" where a date is demanded.
inline constexpr std::string_view no_date = "0001-01-01";

// Names of characteristics, which a device has to have: what it speaks, and the comments of an EDS.
inline constexpr std::string_view protocol_characteristic = "Protocol";
inline constexpr std::string_view comments_characteristic = "Comments";

}  // namespace cgw::xdd
