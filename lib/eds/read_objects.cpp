// The sections of objects and sub-objects.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "eds/reader.hpp"
#include "eds/reading.hpp"
#include "eds/words.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;
using dictionary::Object;
using dictionary::TypeRow;
using dictionary::Variable;
using object::ObjectCode;

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

constexpr KeyRow row(std::string_view name, ObjectKey id) {
    return {name, static_cast<std::uint8_t>(id)};
}

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

constexpr std::uint64_t most_compact_sub_objects = 254;

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

std::optional<Variable> variable_of(Reading& reading, const Section& section, const KeyLines& lines,
                                    ObjectCode code) {
    const TypeRow* const type = read_type(reading, lines[ObjectKey::data_type], section, code);
    const bool has_access = code != ObjectCode::type_definition;
    const auto access =
        has_access ? read_access(reading, lines[ObjectKey::access_type], section) : object::Access::ro;
    if (type == nullptr || !access) {
        return std::nullopt;
    }
    std::optional<Variable> result(std::in_place);
    Variable& variable = *result;
    variable.name = reading.text(lines[ObjectKey::name]);
    variable.type = type->type;
    variable.access = *access;
    reading.assign_flag(lines[ObjectKey::pdo_mapping], variable.pdo_mapping);
    reading.assign(lines[ObjectKey::flags], highest_u32, variable.flags);
    if (auto value = reading.value(lines[ObjectKey::default_value], *type)) {
        variable.default_value = std::move(*value);
    } else {
        variable.no_default = true;
    }
    variable.low_limit = reading.value(lines[ObjectKey::low_limit], *type);
    variable.high_limit = reading.value(lines[ObjectKey::high_limit], *type);
    variable.parameter_value = reading.value(lines[ObjectKey::parameter_value], *type);
    variable.denotation = reading.text(lines[ObjectKey::denotation]);
    variable.upload_file = reading.text(lines[ObjectKey::upload_file]);
    variable.download_file = reading.text(lines[ObjectKey::download_file]);
    return result;
}

// What one object has in `ordered`, from its own section on.
struct Group {
    std::size_t begin = 0;
    std::size_t end = 0;
};

class ObjectReader {
  public:
    ObjectReader(Reading& reading, std::uint8_t module) : reading_(reading), module_(module) {}

    std::vector<Object> read() {
        const std::vector<std::uint32_t>& ordered = reading_.sections.ordered();
        std::vector<Object> objects;
        const auto first = std::partition_point(
            ordered.begin(), ordered.end(),
            [this](std::uint32_t section) { return reading_.sections.name(section).module < module_; });
        constexpr std::ptrdiff_t most_objects = 0x10000;
        objects.reserve(static_cast<std::size_t>(std::min(ordered.end() - first, most_objects)));
        for (auto at = static_cast<std::size_t>(first - ordered.begin()); at < ordered.size();) {
            const SectionName& name = reading_.sections.name(ordered[at]);
            if (name.module != module_) {
                break;
            }
            if (name.kind < SectionKind::object || name.kind > SectionKind::object_links) {
                ++at;
                continue;
            }
            Group group{at, at + 1};
            while (group.end < ordered.size() && belongs(reading_.sections.name(ordered[group.end]), name)) {
                ++group.end;
            }
            read_group(group, objects);
            at = group.end;
        }
        return objects;
    }

  private:
    static bool belongs(const SectionName& name, const SectionName& first) {
        return name.module == first.module && name.index == first.index && name.kind >= SectionKind::object &&
               name.kind <= SectionKind::object_links;
    }

    const SectionName& name_at(std::size_t at) const {
        return reading_.sections.name(reading_.sections.ordered()[at]);
    }
    const Section& section_at(std::size_t at) const {
        return reading_.section(reading_.sections.ordered()[at]);
    }
    bool is_repeated(std::size_t at, std::size_t begin) const {
        return at > begin && name_at(at).kind == name_at(at - 1).kind &&
               name_at(at).sub_index == name_at(at - 1).sub_index;
    }

    void read_group(const Group& group, std::vector<Object>& objects) {
        if (name_at(group.begin).kind != SectionKind::object) {
            for (std::size_t at = group.begin; at < group.end; ++at) {
                report_alone(at);
            }
            return;
        }
        const Section& section = section_at(group.begin);
        const KeyLines lines = reading_.key_lines(section, object_keys);
        Object& object = objects.emplace_back();
        object.index = name_at(group.begin).index;
        object.name = reading_.text(lines[ObjectKey::name]);
        read_parts(group, section, lines, object);
        if (!has_sub_objects(object.code) && object.variables.empty()) {
            objects.pop_back();  // without data, or a finding has said why
        }
    }

    void read_parts(const Group& group, const Section& section, const KeyLines& lines, Object& object) {
        const auto compact = static_cast<std::uint8_t>(
            reading_.number(lines[ObjectKey::compact_sub_objects], most_compact_sub_objects).value_or(0));
        const bool with_sub_objects = compact > 0 || has_sub_section(group);
        object.code = code_of(section, lines[ObjectKey::object_type], with_sub_objects);
        if (object.code == ObjectCode::null) {
            return;
        }
        if (!has_sub_objects(object.code)) {
            if (auto variable = variable_of(reading_, section, lines, object.code)) {
                object.variables.push_back(std::move(*variable));
                ++reading_.variables;
            }
        } else {
            reading_.assign(lines[ObjectKey::flags], highest_u32, object.flags);
            object.denotation = reading_.text(lines[ObjectKey::denotation]);
            read_sub_objects(group, object);
            if (compact > 0) {
                add_compact_variables(reading_, reading_.sections.ordered()[group.begin], compact, object);
            }
        }
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (name_at(at).kind > SectionKind::sub_object && !is_repeated(at, group.begin)) {
                read_compact_entries(reading_, reading_.sections.ordered()[at], object);
            }
        }
    }

    bool has_sub_section(const Group& group) const {
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (name_at(at).kind == SectionKind::sub_object) {
                return true;
            }
        }
        return false;
    }

    // VAR where it is not stated (CiA 306), but for an object that has sub-objects all the same.
    ObjectCode code_of(const Section& section, std::uint32_t line, bool with_sub_objects) {
        const std::optional<ObjectCode> stated = read_code(reading_, line);
        if (!with_sub_objects || (stated && has_sub_objects(*stated))) {
            return stated.value_or(ObjectCode::var);
        }
        const std::string what =
            stated ? fmt::format("{}, which has no sub-objects", reading_.quoted_value(line))
                   : std::string("the ObjectType is missing");
        reading_.report(
            rules::eds_object_type,
            stated ? reading_.document.value_span(line) : reading_.document.name_span(section),
            fmt::format("{}; {} has sub-objects and is read as a record", what, reading_.quoted(section)));
        return ObjectCode::record;
    }

    void read_sub_objects(const Group& group, Object& object) {
        constexpr std::size_t most_sub_objects = 0x100;
        object.variables.reserve(std::min(group.end - group.begin - 1, most_sub_objects));
        std::size_t first = group.begin;  // section of the sub-index
        for (std::size_t at = group.begin; at < group.end; ++at) {
            if (name_at(at).kind != SectionKind::sub_object) {
                continue;
            }
            if (is_repeated(at, group.begin)) {
                report_other_spelling(first, at);
                continue;
            }
            first = at;
            if (reading_.variables >= most_variables) {
                reading_.report(rules::eds_too_much, reading_.document.name_span(section_at(at)),
                                "this and all further sub-objects are left out");
                return;
            }
            if (auto variable = read_variable(reading_, reading_.sections.ordered()[at])) {
                variable->sub_index = name_at(at).sub_index;
                object.variables.push_back(std::move(*variable));
                ++reading_.variables;
            }
        }
    }

    // [1018sub01] beside [1018sub1]; that names are equal has been told already.
    void report_other_spelling(std::size_t first, std::size_t at) {
        const std::vector<std::uint32_t>& ordered = reading_.sections.ordered();
        if (!reading_.document.same_name(ordered[first], ordered[at])) {
            reading_.report(rules::eds_section_twice, reading_.document.name_span(section_at(at)),
                            fmt::format("{} is the sub-object of {}; this one is not read",
                                        reading_.quoted(section_at(at)), reading_.quoted(section_at(first))));
        }
    }

    void report_alone(std::size_t at) {
        reading_.report(rules::eds_section_alone, reading_.document.name_span(section_at(at)),
                        fmt::format("{} belongs to [{:04X}], which is missing; it is left out",
                                    reading_.quoted(section_at(at)), name_at(at).index));
    }

    Reading& reading_;
    std::uint8_t module_;
};

}  // namespace

std::optional<Variable> read_variable(Reading& reading, std::uint32_t section) {
    const Section& of = reading.section(section);
    const KeyLines lines = reading.key_lines(of, object_keys);
    const ObjectCode code = read_code(reading, lines[ObjectKey::object_type]).value_or(ObjectCode::var);
    return variable_of(reading, of, lines, code);
}

std::vector<Object> read_objects(Reading& reading, std::uint8_t module) {
    return ObjectReader(reading, module).read();
}

}  // namespace cgw::eds
