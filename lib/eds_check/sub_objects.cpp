// Sub-objects: how many they are, what sub-object 0 says of them, their types.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/counts.hpp"
#include "eds_check/parents.hpp"
#include "eds_check/standard_objects.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using object::DataType;
using object::ObjectCode;

constexpr std::uint8_t structure_sub_index = 0xFF;

// Of CiA 301, and none that a sub-object has; what is no object type at all is told by the reader.
constexpr std::array codes_of_others{ObjectCode::null, ObjectCode::type_definition,
                                     ObjectCode::structure_definition, ObjectCode::array, ObjectCode::record};

// CompactSubObj tells the number: SubNumber is 0, or agrees with it.
void check_compact_sub_numbers(const Context& context) {
    for (const Group& group : context.model.all_groups()) {
        if (!group.has_section || !is_parent(group, group.own()) || !is_compact(context, group.own())) {
            continue;
        }
        const std::uint32_t line = group.own().lines[ObjectKey::sub_number];
        const auto stated = context.number(line);
        const auto compact = context.number(group.own().lines[ObjectKey::compact_sub_objects]);
        if (stated && *stated != 0 && *stated != *compact + 1) {
            context.reading.report(
                rules::eds_sub_number, context.document.value_span(line),
                fmt::format("SubNumber is {}, and by its CompactSubObj {} has {} sub-objects", *stated,
                            context.label(group.own()), *compact + 1));
        }
    }
}

}  // namespace

std::size_t sub_objects_of(const Group& group) {
    const auto subs = group.sub_objects();
    return static_cast<std::size_t>(std::count_if(
        subs.begin(), subs.end(), [](const Part& part) { return part.sub_index != structure_sub_index; }));
}

void check_sub_numbers(const Context& context) {
    check_compact_sub_numbers(context);
    for_each_parent(context, [&](const Group& group) {
        const std::uint32_t line = group.own().lines[ObjectKey::sub_number];
        const std::size_t count = sub_objects_of(group);
        const auto stated = context.number(line);
        if (stated && *stated != count) {
            context.reading.report(rules::eds_sub_number, context.document.value_span(line),
                                   fmt::format("SubNumber is {}, and {} has {} sub-object{}", *stated,
                                               context.label(group.own()), count, count == 1 ? "" : "s"));
        }
    });
}

void check_sub_numbers_stated(const Context& context) {
    for_each_parent(context, [&](const Group& group) {
        if (!context.stated(group.own().lines[ObjectKey::sub_number])) {
            context.reading.report(rules::eds_sub_number_absent, context.header_of(group.own().section),
                                   fmt::format("{} has no SubNumber", context.label(group.own())));
        }
    });
}

void check_first_sub_objects(const Context& context) {
    for_each_parent(context, [&](const Group& group) {
        if (group.find(0) == nullptr) {
            context.reading.report(rules::eds_sub_0_absent, context.header_of(group.own().section),
                                   fmt::format("{} has no sub-object 0", context.label(group.own())));
        }
    });
}

void check_first_sub_types(const Context& context) {
    for_each_parent(context, [&](const Group& group) {
        const Part* const first = group.find(0);
        if (first != nullptr && first->variable != nullptr && first->variable->type != DataType::unsigned8) {
            context.reading.report(
                rules::eds_sub_0_type, context.document.value_span(first->lines[ObjectKey::data_type]),
                fmt::format("{} is {}; the number of entries is UNSIGNED8", context.label(*first),
                            dictionary::row_of(first->variable->type).name));
        }
    });
}

void check_first_sub_values(const Context& context) {
    for_each_parent(context, [&](const Group& group) {
        const Part* const first = group.find(0);
        const auto stated = first != nullptr ? number_of(first->variable) : std::nullopt;
        if (!stated || counts_entries_in_use(group.index)) {
            return;
        }
        std::uint8_t highest = 0;
        for (const Part& part : group.sub_objects()) {
            highest = part.sub_index != structure_sub_index ? std::max(highest, part.sub_index) : highest;
        }
        if (*stated != highest) {
            context.reading.report(
                rules::eds_sub_0_value, context.value_place(group, 0),
                fmt::format("{} is {}, and the highest sub-index of {} is {}", context.label(*first), *stated,
                            object_text(group.index), highest));
        }
    });
}

void check_defaults(const Context& context) {
    constexpr std::uint16_t identity = 0x1018;
    for_each_parent(context, [&](const Group& group) {
        for (const Part& part : group.sub_objects()) {
            const bool wanted = part.sub_index == 0 || group.index == identity;
            if (wanted && part.variable != nullptr && value_of(*part.variable) == nullptr &&
                !context.stated(part.lines[ObjectKey::default_value])) {
                context.reading.report(rules::eds_default_absent, context.header_of(part.section),
                                       fmt::format("{} has no DefaultValue", context.label(part)));
            }
        }
    });
}

void check_array_types(const Context& context) {
    for_each_parent(context, [&](const Group& group) {
        if (group.object->code != ObjectCode::array) {
            return;
        }
        const Part* first = nullptr;
        for (const Part& part : group.sub_objects()) {
            if (part.sub_index == 0 || part.sub_index == structure_sub_index || part.variable == nullptr) {
                continue;
            }
            first = first == nullptr ? &part : first;
            if (part.variable->type != first->variable->type) {
                const std::uint32_t line = part.lines[ObjectKey::data_type];
                context.reading.report(
                    rules::eds_array_types,
                    line != 0 ? context.document.value_span(line) : context.header_of(part.section),
                    fmt::format("{} is {}, and {} of the same array is {}", context.label(part),
                                dictionary::row_of(part.variable->type).name, context.label(*first),
                                dictionary::row_of(first->variable->type).name));
                return;
            }
        }
    });
}

void check_sub_object_types(const Context& context) {
    for_each_part(context, [&](const Group& group, const Part& part) {
        const std::uint32_t line = part.lines[ObjectKey::object_type];
        const auto stated = context.number(line);
        const bool is_of_other =
            stated && std::any_of(codes_of_others.begin(), codes_of_others.end(), [&](ObjectCode code) {
                return static_cast<std::uint64_t>(code) == *stated;
            });
        if (is_of_other && (part.is_sub_object || group.is_extension)) {
            context.reading.report(
                rules::eds_sub_object_type, context.document.value_span(line),
                fmt::format("ObjectType of {} is 0x{:X}; a sub-object is 0x7 (VAR), or 0x2 (DOMAIN)",
                            context.label(part), *stated));
        }
    });
}

}  // namespace cgw::eds_check
