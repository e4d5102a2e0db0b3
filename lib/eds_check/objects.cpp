// Objects and sub-objects: which keys their type demands and allows, their names, what CiA 301 fixes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds/words.hpp"
#include "eds_check/context.hpp"
#include "eds_check/parents.hpp"
#include "eds_check/standard_objects.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using object::ObjectCode;

// Keys that only one kind of object has.
struct KeyUse {
    ObjectKey key;
    std::string_view name;
    bool of_values;   // of VAR, DOMAIN and sub-objects
    bool of_parents;  // of ARRAY and RECORD
    bool of_compact;  // of those with CompactSubObj
};
constexpr std::array key_uses{
    KeyUse{ObjectKey::data_type, "DataType", true, false, true},
    KeyUse{ObjectKey::access_type, "AccessType", true, false, true},
    KeyUse{ObjectKey::default_value, "DefaultValue", true, false, true},
    KeyUse{ObjectKey::pdo_mapping, "PDOMapping", true, false, true},
    KeyUse{ObjectKey::low_limit, "LowLimit", true, false, true},
    KeyUse{ObjectKey::high_limit, "HighLimit", true, false, true},
    KeyUse{ObjectKey::parameter_value, "ParameterValue", true, false, true},
    KeyUse{ObjectKey::sub_number, "SubNumber", false, true, true},
    KeyUse{ObjectKey::compact_sub_objects, "CompactSubObj", false, true, true},
};

std::string_view name_of(ObjectCode code) {
    switch (code) {
        case ObjectCode::array:
            return "ARRAY";
        case ObjectCode::record:
            return "RECORD";
        case ObjectCode::var:
            return "VAR";
        default:
            return "of another object type";
    }
}

}  // namespace

void check_key_uses(const Context& context) {
    for_each_part(context, [&](const Group& group, const Part& part) {
        if (!part.is_sub_object && group.object == nullptr && !group.is_extension) {
            return;
        }
        const bool parent = is_parent(group, part);
        const bool compact = parent && is_compact(context, part);
        for (const KeyUse& use : key_uses) {
            const bool fits = compact ? use.of_compact : parent ? use.of_parents : use.of_values;
            const std::uint32_t line = part.lines[use.key];
            if (fits || line == 0 || (!parent && context.number(line) == 0U) ||
                context.document.value(line).empty()) {
                continue;
            }
            context.reading.report(
                rules::eds_key_use, context.document.key_span(line),
                parent ? fmt::format("{} stands in {}, which is {}: its sub-objects have one each", use.name,
                                     context.label(part),
                                     group.object->code == ObjectCode::array ? "an ARRAY" : "a RECORD")
                       : fmt::format("{} stands in {}, which has no sub-objects", use.name,
                                     context.label(part)));
        }
    });
}

void check_names(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        if (!context.stated(part.lines[ObjectKey::name])) {
            context.reading.report(rules::eds_name_absent, context.header_of(part.section),
                                   fmt::format("{} has no ParameterName", context.label(part)));
        }
    });
}

void check_equal_names(const Context& context) {
    for (const Group& group : context.model.all_groups()) {
        std::set<std::string_view> names;
        for (const Part& part : group.sub_objects()) {
            const std::uint32_t line = part.lines[ObjectKey::name];
            if (context.stated(line) && !names.insert(context.document.value(line)).second) {
                context.reading.report(
                    rules::eds_names_equal, context.document.value_span(line),
                    fmt::format("another sub-object of {} has this name", object_text(group.index)));
            }
        }
    }
}

void check_object_types_stated(const Context& context) {
    for_each_part(context, [&](const Group& group, const Part& part) {
        const bool told = !part.is_sub_object && !group.sub_objects().empty();  // by the reader
        if (!told && !group.is_extension && !context.stated(part.lines[ObjectKey::object_type])) {
            context.reading.report(rules::eds_object_type_absent, context.header_of(part.section),
                                   fmt::format("{} has no ObjectType; VAR is meant", context.label(part)));
        }
    });
}

void check_standard_codes(const Context& context) {
    for (const Group& group : context.model.all_groups()) {
        const auto standard = standard_code(group.index);
        if (!standard || group.object == nullptr || !group.has_section || group.object->code == *standard ||
            !context.stated(group.own().lines[ObjectKey::object_type])) {
            continue;
        }
        context.reading.report(rules::eds_standard_code,
                               context.document.value_span(group.own().lines[ObjectKey::object_type]),
                               fmt::format("{} is {} here; CiA 301 has it as {}", object_text(group.index),
                                           name_of(group.object->code), name_of(*standard)),
                               fmt::format("write 0x{:X}", static_cast<unsigned>(*standard)));
    }
}

void check_standard_types(const Context& context) {
    for_each_part(context, [&](const Group& group, const Part& part) {
        const auto standard = standard_type(part.index, part.sub_index);
        const bool has_sub = group.object != nullptr && object::has_sub_objects(group.object->code);
        if (standard && group.object != nullptr && part.variable != nullptr &&
            part.variable->type != *standard && has_sub == is_parent_by_standard(part.index)) {
            context.reading.report(
                rules::eds_standard_type, context.document.value_span(part.lines[ObjectKey::data_type]),
                fmt::format("{} is {} here; CiA 301 has it as {}",
                            has_sub ? object_text(part.index, part.sub_index) : object_text(part.index),
                            dictionary::row_of(part.variable->type).name,
                            dictionary::row_of(*standard).name));
        }
    });
}

void check_access_case(const Context& context) {
    for_each_part(context, [&](const Group&, const Part& part) {
        const std::uint32_t line = part.lines[ObjectKey::access_type];
        if (!context.stated(line)) {
            return;
        }
        const std::string_view word = context.document.value(line);
        const bool known =
            std::any_of(eds::access_types.begin(), eds::access_types.end(), [&](std::string_view each) {
                return each.size() == word.size() && base::equal_ignoring_case(each, word);
            });
        if (known && base::lowered(word) != word) {
            context.reading.report(
                rules::eds_access_case, context.document.value_span(line),
                fmt::format("AccessType is `{}`; CiA 306 writes {}", word, base::lowered(word)));
        }
    });
}

}  // namespace cgw::eds_check
