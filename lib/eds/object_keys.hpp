// The keys of objects and sub-objects, and one variable of them.
#pragma once

#include <optional>

#include "eds/reading.hpp"

namespace cgw::eds {

enum class ObjectKey : std::uint8_t {
    name,
    object_type,
    data_type,
    access_type,
    default_value,
    parameter_value,
    pdo_mapping,
    low_limit,
    high_limit,
    sub_number,
    flags,
    compact_sub_objects,
    denotation,
    upload_file,
    download_file,
};

KeyLines object_key_lines(Reading& reading, const Section& section);

// Nothing when the key is not there, or is no object type, which is a finding then.
std::optional<object::ObjectCode> read_code(Reading& reading, std::uint32_t line);

// False, and `variable` is to be thrown away, when its type or access cannot be read.
bool read_into(dictionary::Variable& variable, Reading& reading, const Section& section,
               const KeyLines& lines, object::ObjectCode code);

}  // namespace cgw::eds
