#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "diagnostic/rules/eds.hpp"
#include "eds/object_keys.hpp"
#include "eds/words.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;
using dictionary::TypeRow;
using dictionary::Variable;
using object::ObjectCode;

constexpr std::array object_keys{
    row("ParameterName", ObjectKey::name),
    row("ObjectType", ObjectKey::object_type),
    row("SubNumber", ObjectKey::sub_number),
    row("DataType", ObjectKey::data_type),
    row("AccessType", ObjectKey::access_type),
    row("DefaultValue", ObjectKey::default_value),
    row("ParameterValue", ObjectKey::parameter_value),
    row("PDOMapping", ObjectKey::pdo_mapping),
    row("LowLimit", ObjectKey::low_limit),
    row("HighLimit", ObjectKey::high_limit),
    row("ObjFlags", ObjectKey::flags),
    row("CompactSubObj", ObjectKey::compact_sub_objects),
    row("Denotation", ObjectKey::denotation),
    row("UploadFile", ObjectKey::upload_file),
    row("DownloadFile", ObjectKey::download_file),
};

constexpr std::array object_codes{
    ObjectCode::null, ObjectCode::domain, ObjectCode::type_definition, ObjectCode::structure_definition,
    ObjectCode::var,  ObjectCode::array,  ObjectCode::record};

const TypeRow* read_type(Reading& reading, std::uint32_t line, const Section& section, ObjectCode code) {
    const auto number = reading.number(line, highest_u32);
    if (!number && code == ObjectCode::domain) {
        return &dictionary::row_of(object::DataType::domain);
    }
    if (!number) {
        if (line == 0 || reading.document.value(line).empty()) {
            reading.report(rules::eds_key_absent, reading.document.name_span(section),
                           fmt::format("{} has no DataType; it is left out", reading.quoted(section)));
        }
        return nullptr;
    }
    const TypeRow* const type = dictionary::find_type(*number);
    if (type == nullptr) {
        reading.report(rules::eds_data_type, reading.document.value_span(line),
                       fmt::format("{}, which is no data type of CiA 301; {} is left out",
                                   reading.quoted_value(line), reading.quoted(section)));
    }
    return type;
}

std::optional<object::Access> read_access(Reading& reading, std::uint32_t line, const Section& section) {
    if (line == 0 || reading.document.value(line).empty()) {
        reading.report(rules::eds_key_absent, reading.document.name_span(section),
                       fmt::format("{} has no AccessType; it is left out", reading.quoted(section)));
        return std::nullopt;
    }
    const std::string_view word = reading.document.value(line);
    for (std::size_t i = 0; i < access_types.size(); ++i) {
        if (access_types[i].size() == word.size() && base::equal_ignoring_case(access_types[i], word)) {
            return static_cast<object::Access>(i);
        }
    }
    reading.report(rules::eds_access_type, reading.document.value_span(line),
                   fmt::format("{}; it can be ro, wo, rw, rwr, rww or const; {} is left out",
                               reading.quoted_value(line), reading.quoted(section)));
    return std::nullopt;
}

}  // namespace

KeyLines object_key_lines(Reading& reading, const Section& section) {
    return reading.key_lines(section, object_keys);
}

std::optional<ObjectCode> read_code(Reading& reading, std::uint32_t line) {
    const auto number = reading.number(line, highest_u32);
    if (!number) {
        return std::nullopt;
    }
    const auto* const code = std::find_if(object_codes.begin(), object_codes.end(), [&](ObjectCode each) {
        return static_cast<std::uint64_t>(each) == *number;
    });
    if (code == object_codes.end()) {
        reading.report(rules::eds_object_type, reading.document.value_span(line),
                       fmt::format("{}, which is no object type of CiA 301", reading.quoted_value(line)));
        return std::nullopt;
    }
    return *code;
}

bool read_into(Variable& variable, Reading& reading, const Section& section, const KeyLines& lines,
               ObjectCode code) {
    const TypeRow* const type = read_type(reading, lines[ObjectKey::data_type], section, code);
    const bool has_access = code != ObjectCode::type_definition;
    const auto access =
        has_access ? read_access(reading, lines[ObjectKey::access_type], section) : object::Access::ro;
    if (type == nullptr || !access) {
        return false;
    }
    reading.assign_text(lines[ObjectKey::name], variable.name);
    variable.type = type->type;
    variable.access = *access;
    reading.assign_flag(lines[ObjectKey::pdo_mapping], variable.pdo_mapping);
    reading.assign(lines[ObjectKey::flags], highest_u32, variable.flags);
    if (auto value = reading.value(lines[ObjectKey::default_value], *type)) {
        variable.default_value = std::move(*value);
    } else {
        variable.no_default = true;
    }
    for (const auto& [key, value] : {std::pair(ObjectKey::low_limit, &variable.low_limit),
                                     std::pair(ObjectKey::high_limit, &variable.high_limit),
                                     std::pair(ObjectKey::parameter_value, &variable.parameter_value)}) {
        if (lines[key] != 0) {
            *value = reading.value(lines[key], *type);
        }
    }
    reading.assign_text(lines[ObjectKey::denotation], variable.denotation);
    reading.assign_text(lines[ObjectKey::upload_file], variable.upload_file);
    reading.assign_text(lines[ObjectKey::download_file], variable.download_file);
    return true;
}

std::optional<Variable> read_variable(Reading& reading, std::uint32_t section) {
    const Section& of = reading.section(section);
    const KeyLines lines = object_key_lines(reading, of);
    const ObjectCode code = read_code(reading, lines[ObjectKey::object_type]).value_or(ObjectCode::var);
    Variable variable;
    return read_into(variable, reading, of, lines, code) ? std::optional(std::move(variable)) : std::nullopt;
}

}  // namespace cgw::eds
