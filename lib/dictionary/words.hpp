// What CiA 301 and CiA 306 call access and kinds of objects.
#pragma once

#include <array>
#include <string_view>

#include "object/vocabulary.hpp"

namespace cgw::dictionary {

// Spelling of object::Access, in the order of its values.
inline constexpr std::array<std::string_view, 6> access_types{"ro", "wo", "rw", "rwr", "rww", "const"};

struct ObjectCodeName {
    object::ObjectCode code;
    std::string_view name;
};

inline constexpr std::array<ObjectCodeName, 7> object_codes{{
    {object::ObjectCode::null, "NULL"},
    {object::ObjectCode::domain, "DOMAIN"},
    {object::ObjectCode::type_definition, "DEFTYPE"},
    {object::ObjectCode::structure_definition, "DEFSTRUCT"},
    {object::ObjectCode::var, "VAR"},
    {object::ObjectCode::array, "ARRAY"},
    {object::ObjectCode::record, "RECORD"},
}};

}  // namespace cgw::dictionary
