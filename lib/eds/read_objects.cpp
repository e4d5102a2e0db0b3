// The sections of objects and sub-objects.
#include <fmt/format.h>

#include <algorithm>

#include "diagnostic/rules/eds.hpp"
#include "eds/object_keys.hpp"
#include "eds/reader.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;
using dictionary::Object;
using dictionary::Variable;
using object::ObjectCode;

constexpr std::uint64_t most_compact_sub_objects = 254;

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
        const auto last = std::partition_point(first, ordered.end(), [this](std::uint32_t section) {
            return reading_.sections.name(section).module <= module_;
        });
        constexpr std::ptrdiff_t most_objects = 0x10000;
        objects.reserve(static_cast<std::size_t>(std::min(last - first, most_objects)));
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
        const KeyLines lines = object_key_lines(reading_, section);
        Object& object = objects.emplace_back();
        object.index = name_at(group.begin).index;
        reading_.assign_text(lines[ObjectKey::name], object.name);
        // Whether it counts right is not the reader's question.
        reading_.number(lines[ObjectKey::sub_number], highest_u32);
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
            add_variable(section, lines, object.code, 0, object);
        } else {
            reading_.assign(lines[ObjectKey::flags], highest_u32, object.flags);
            reading_.assign_text(lines[ObjectKey::denotation], object.denotation);
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
            const KeyLines lines = object_key_lines(reading_, section_at(at));
            const auto code = read_code(reading_, lines[ObjectKey::object_type]).value_or(ObjectCode::var);
            add_variable(section_at(at), lines, code, name_at(at).sub_index, object);
        }
    }

    void add_variable(const Section& section, const KeyLines& lines, ObjectCode code, std::uint8_t sub_index,
                      Object& object) {
        Variable& variable = object.variables.emplace_back();
        if (read_into(variable, reading_, section, lines, code)) {
            variable.sub_index = sub_index;
            ++reading_.variables;
        } else {
            object.variables.pop_back();
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

std::vector<Object> read_objects(Reading& reading, std::uint8_t module) {
    return ObjectReader(reading, module).read();
}

}  // namespace cgw::eds
