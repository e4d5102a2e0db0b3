// Repairs of what the file says of itself: counts, numbers of lists, types that CiA 301 fixes, dates.
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "eds_check/context.hpp"
#include "eds_check/counts.hpp"
#include "eds_check/dates.hpp"
#include "eds_check/repairs.hpp"
#include "eds_check/standard_objects.hpp"

namespace cgw::eds_check {
namespace {

constexpr std::size_t longest_shown = 60;

// Of the entry on the line: "SubNumber=5 becomes 4".
Repair restated(const Context& context, const Span& place, std::string text) {
    std::string what =
        fmt::format("{}={} becomes {}", context.document.key(place.line),
                    base::printable(context.document.view(place).substr(0, longest_shown)), text);
    return {std::move(what), {{Change::Kind::replace, place, std::move(text)}}};
}

const eds::Section& section_of(const Context& context, std::uint32_t line) {
    const std::span<const eds::Section> sections = context.document.sections();
    const auto behind =
        std::upper_bound(sections.begin(), sections.end(), line,
                         [](std::uint32_t wanted, const eds::Section& each) { return wanted < each.header; });
    return *std::prev(behind);
}

std::uint32_t number_of(const Context& context, const eds::Section& section) {
    return static_cast<std::uint32_t>(&section - context.document.sections().data());
}

// The object or sub-object on whose section a finding stands.
struct Found {
    const Group* group = nullptr;
    const Part* part = nullptr;
};
Found part_at(const Context& context, std::uint32_t line) {
    const std::uint32_t section = number_of(context, section_of(context, line));
    const Group* const group = context.model.find(context.sheet.sections.name(section));
    if (group == nullptr) {
        return {};
    }
    const auto part = std::find_if(group->parts.begin(), group->parts.end(),
                                   [section](const Part& each) { return each.section == section; });
    return {group, part != group->parts.end() ? &*part : nullptr};
}

Repair stated(const Part& part, std::uint32_t header, std::initializer_list<ObjectKey> behind,
              const std::string& entry) {
    std::uint32_t line = header;
    for (const ObjectKey key : behind) {
        line = std::max(line, part.lines[key]);
    }
    return {fmt::format("{} is added", entry), {{Change::Kind::insert_after, {line, 0, 0}, entry}}};
}

}  // namespace

std::optional<Repair> mend_count(const Context& context, const Span& place) {
    const eds::Section& section = section_of(context, place.line);
    const std::size_t count = entries_of(context, section);
    // One more entry may be meant by a key that says nothing.
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (context.document.lines()[line].kind == eds::LineKind::entry &&
            context.model.key_row(line) == nullptr) {
            return std::nullopt;
        }
    }
    // A list that is counted and gone may have been lost: which entries it had, nobody knows.
    return count > 0 ? std::optional(restated(context, place, fmt::format("{}", count))) : std::nullopt;
}

std::optional<Repair> number_list(const Context& context, const Span& place) {
    const eds::Section& section = section_of(context, place.line);
    Repair repair{"the entries of the list are numbered again"};
    std::size_t number = 0;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (!is_list_entry(context, line)) {
            continue;
        }
        Span digits = context.document.key_span(line);
        digits.begin += static_cast<std::uint32_t>(context.model.key_row(line)->name.size());
        const std::string right = fmt::format("{}", ++number);
        if (context.document.view(digits) != right) {
            repair.changes.push_back({Change::Kind::replace, digits, right});
        }
    }
    return repair;
}

std::optional<Repair> unlist(const Context& context, const Span& place) {
    const std::uint32_t section = number_of(context, section_of(context, place.line));
    const auto index = static_cast<std::uint16_t>(context.number(place.line).value_or(0));
    if (context.model.first_listing(context.kind_of(section), index) >= place.line) {
        return std::nullopt;  // it stands in two lists: which one is wrong is told by another rule
    }
    if (!context.model.unlisted().empty()) {
        return std::nullopt;  // the entry may have been meant for one of them
    }
    return Repair{fmt::format("the second entry of {} is taken away", object_text(index)),
                  {{Change::Kind::remove_line, place, ""}}};
}

std::optional<Repair> mend_sub_number(const Context& context, const Span& place) {
    const Found found = part_at(context, place.line);
    if (found.part == nullptr) {
        return std::nullopt;
    }
    if (context.number(found.part->lines[ObjectKey::compact_sub_objects]).value_or(0) > 0) {
        return std::nullopt;  // which of the two is right?
    }
    // Where sub-object 0 says the same, a section is missing, and the number may be right.
    const std::size_t count = sub_objects_of(*found.group);
    const Part* const first = found.group->find(0);
    const auto highest = first != nullptr ? number_of(first->variable) : std::nullopt;
    const auto said = context.number(place.line);
    if (highest && said && *said > count && *said == *highest + 1) {
        return std::nullopt;
    }
    return restated(context, place, fmt::format("{}", count));
}

std::optional<Repair> state_sub_number(const Context& context, const Span& place) {
    const Found found = part_at(context, place.line);
    if (found.part == nullptr) {
        return std::nullopt;
    }
    const std::string entry = fmt::format("SubNumber={}", sub_objects_of(*found.group));
    if (const std::uint32_t line = found.part->lines[ObjectKey::sub_number]; line != 0) {
        return Repair{fmt::format("{} is stated", entry),
                      {{Change::Kind::replace, context.document.line_span(line), entry}}};
    }
    return stated(*found.part, place.line, {ObjectKey::name, ObjectKey::object_type}, entry);
}

std::optional<Repair> state_object_type(const Context& context, const Span& place) {
    const Found found = part_at(context, place.line);
    if (found.part == nullptr || found.part->variable == nullptr) {
        return std::nullopt;
    }
    const std::string entry = "ObjectType=0x7";
    if (const std::uint32_t line = found.part->lines[ObjectKey::object_type]; line != 0) {
        return Repair{fmt::format("{} is stated", entry),
                      {{Change::Kind::replace, context.document.line_span(line), entry}}};
    }
    return stated(*found.part, place.line, {ObjectKey::name}, entry);
}

// Where the data type is one of single values, and the access is stated, VAR is meant.
std::optional<Repair> mend_sub_object_type(const Context& context, const Span& place) {
    const Found found = part_at(context, place.line);
    const dictionary::Variable* const variable = found.part != nullptr ? found.part->variable : nullptr;
    if (variable == nullptr || !context.stated(found.part->lines[ObjectKey::access_type]) ||
        !context.stated(found.part->lines[ObjectKey::data_type]) ||
        variable->type == object::DataType::domain) {
        return std::nullopt;
    }
    return restated(context, place, "0x7");
}

std::optional<Repair> mend_standard_code(const Context& context, const Span& place) {
    const Found found = part_at(context, place.line);
    const auto standard = found.group != nullptr ? standard_code(found.group->index) : std::nullopt;
    if (!standard || found.group->object == nullptr || !object::has_sub_objects(found.group->object->code)) {
        return std::nullopt;
    }
    return restated(context, place, fmt::format("0x{:X}", static_cast<unsigned>(*standard)));
}

std::optional<Repair> mend_pdo_count(const Context& context, const Span& place) {
    const std::string_view key = context.document.key(place.line);
    const auto count = lacks_pdos(context, key) ? std::nullopt : described_pdos(context, key);
    return count ? std::optional(restated(context, place, fmt::format("{}", *count))) : std::nullopt;
}

std::optional<Repair> mend_identity(const Context& context, const Span& place) {
    const auto held = identity_number(context, context.document.key(place.line));
    const bool unstated = context.number(place.line) == 0U;
    // A revision of 0 is a revision; vendors and products have other numbers.
    if (!held || !unstated || !is_numbered_from_1(context.document.key(place.line))) {
        return std::nullopt;
    }
    return restated(context, place, fmt::format("0x{:08X}", *held));
}

// A value ends at `;`, a line has 255 characters of ASCII, and blanks at the ends of a value are none of it.
std::optional<Repair> mend_file_name(const Context& context, const Span& place) {
    constexpr std::size_t longest = 240;
    const std::string_view name = context.options.file_name;
    const bool fits =
        name.size() <= longest && base::trimmed(name) == name &&
        std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~' && c != ';'; });
    if (!fits) {
        return std::nullopt;
    }
    return restated(context, place, context.options.file_name);
}

std::optional<Repair> mend_version(const Context& context, const Span& place) {
    return context.document.view(place) == "4" ? std::optional(restated(context, place, "4.0"))
                                               : std::nullopt;
}

std::optional<Repair> mend_date(const Context& context, const Span& place) {
    const auto date = as_date(context.document.view(place));
    return date ? std::optional(restated(context, place, *date)) : std::nullopt;
}

std::optional<Repair> mend_time(const Context& context, const Span& place) {
    const auto time = as_time(context.document.view(place));
    return time ? std::optional(restated(context, place, *time)) : std::nullopt;
}

}  // namespace cgw::eds_check
