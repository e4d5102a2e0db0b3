// Lists of objects and of values, against each other and against the sections.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/ascii.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/context.hpp"
#include "eds_check/counts.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using eds::SectionKind;

// Sections whose entries are numbered from 1 without a gap.
bool is_numbered(SectionKind kind) {
    constexpr std::array kinds{
        SectionKind::mandatory_objects,  SectionKind::optional_objects,  SectionKind::manufacturer_objects,
        SectionKind::object_links,       SectionKind::connected_modules, SectionKind::module_fixed_objects,
        SectionKind::module_sub_extends, SectionKind::comments,          SectionKind::module_comments};
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

// Sections with numbered entries, and the key that says how many they are.
struct Counted {
    SectionKind kind;
    std::string_view key;
    const diagnostic::Rule* rule;
};
const std::array counted{
    Counted{SectionKind::mandatory_objects, "SupportedObjects", &rules::eds_list_count},
    Counted{SectionKind::optional_objects, "SupportedObjects", &rules::eds_list_count},
    Counted{SectionKind::manufacturer_objects, "SupportedObjects", &rules::eds_list_count},
    Counted{SectionKind::names, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::values, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::denotations, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::object_links, "ObjectLinks", &rules::eds_entry_count},
    Counted{SectionKind::connected_modules, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::module_fixed_objects, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::module_sub_extends, "NrOfEntries", &rules::eds_entry_count},
    Counted{SectionKind::comments, "Lines", &rules::eds_comment_count},
    Counted{SectionKind::module_comments, "Lines", &rules::eds_comment_count},
};

// The number of an entry; 0: none that a reader looks for.
std::size_t place_of(std::string_view key) {
    constexpr std::size_t most_digits = 9;
    std::size_t place = 0;
    if (key.starts_with('0') || key.size() > most_digits) {
        return place;
    }
    for (const char c : key) {
        place = place * 10 + static_cast<std::size_t>(c - '0');
    }
    return place;
}

void check_counts(const Context& context, const diagnostic::Rule& rule) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        const SectionKind kind = context.kind_of(number);
        const auto* const row = std::find_if(counted.begin(), counted.end(), [&](const Counted& each) {
            return each.kind == kind && each.rule == &rule;
        });
        if (row == counted.end()) {
            continue;
        }
        const auto line = context.document.find(sections[number], row->key);
        const auto stated = context.number(line.value_or(0));
        const std::size_t count = entries_of(context, sections[number]);
        if (stated && *stated != count) {
            context.reading.report(
                rule, context.document.value_span(*line),
                fmt::format("{} says {} {}, and {} {} there", row->key, *stated,
                            *stated == 1 ? "entry" : "entries", count, count == 1 ? "stands" : "stand"));
        }
    }
}

// 1=2000, where [2000] stands in the file.
std::string hexadecimal_meant(const Context& context, const Listed& entry) {
    constexpr std::size_t index_digits = 4;
    const std::string_view text = context.document.value(entry.line);
    if (text.size() != index_digits || !base::consists_of(text, base::hexadecimal_digits)) {
        return "";
    }
    const auto meant = eds::parse_section_name(text);
    return context.model.find(meant) != nullptr
               ? fmt::format("{} is a decimal number; is 0x{} meant?", text, text)
               : "";
}

SectionKind list_for(std::uint16_t index) {
    constexpr std::uint16_t manufacturer_begin = 0x2000;
    constexpr std::uint16_t manufacturer_end = 0x6000;
    if (index == 0x1000 || index == 0x1001 || index == 0x1018) {
        return SectionKind::mandatory_objects;
    }
    return index >= manufacturer_begin && index < manufacturer_end ? SectionKind::manufacturer_objects
                                                                   : SectionKind::optional_objects;
}

}  // namespace

bool is_list_entry(const Context& context, std::uint32_t line) {
    const KeyRow* const row = context.model.key_row(line);
    return row != nullptr && row->tail == Tail::number;
}

std::size_t entries_of(const Context& context, const eds::Section& section) {
    std::size_t count = 0;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        count += is_list_entry(context, line) ? 1U : 0U;
    }
    return count;
}

void check_list_counts(const Context& context) {
    check_counts(context, rules::eds_list_count);
}

void check_entry_counts(const Context& context) {
    check_counts(context, rules::eds_entry_count);
}

void check_comment_counts(const Context& context) {
    check_counts(context, rules::eds_comment_count);
}

void check_list_numbers(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        if (!is_numbered(context.kind_of(number))) {
            continue;
        }
        const eds::Section& of = sections[number];
        std::vector<bool> seen(entries_of(context, of) + 1);
        for (std::uint32_t line = of.header + 1; line < of.end; ++line) {
            if (!is_list_entry(context, line)) {
                continue;
            }
            const std::string_view key = context.document.key(line);
            const std::size_t place = place_of(key.substr(context.model.key_row(line)->name.size()));
            if (place >= 1 && place < seen.size() && !seen[place]) {
                seen[place] = true;
                continue;
            }
            context.reading.report(
                rules::eds_list_numbers, context.document.key_span(line),
                fmt::format("a list of {} has an entry {}; they are numbered from 1 without a gap",
                            seen.size() - 1, key.substr(0, 20)));
        }
    }
}

void check_listed_twice(const Context& context) {
    std::map<std::uint16_t, std::uint32_t> lines;
    for (const Listed& each : context.model.listed()) {
        const auto [first, is_new] = lines.try_emplace(each.index, each.line);
        if (!is_new) {
            context.reading.report(
                rules::eds_listed_twice, context.document.value_span(each.line),
                fmt::format("{} is listed already", object_text(each.index)), "",
                {{context.reading.location(context.document.value_span(first->second)), "here"}});
        }
    }
}

void check_listed_objects(const Context& context) {
    for (const Listed& each : context.model.listed()) {
        if (context.model.find(each.index) == nullptr &&
            context.sheet.dictionary.find(each.index) == nullptr) {
            context.reading.report(
                rules::eds_listed_absent, context.document.value_span(each.line),
                fmt::format("{} is listed, and [{:04X}] is missing", object_text(each.index), each.index),
                hexadecimal_meant(context, each));
        }
    }
}

void check_unlisted_objects(const Context& context) {
    for (const Group* const group : context.model.unlisted()) {
        const SectionKind list = list_for(group->index);
        const auto section = context.sheet.sections.find(list);
        std::vector<diagnostic::Related> related;
        if (section) {
            related.push_back({context.reading.location(context.header_of(*section)), "its list"});
        }
        context.reading.report(rules::eds_unlisted, context.header_of(group->own().section),
                               fmt::format("{} is in none of the lists of objects; it belongs into [{}]",
                                           context.label(group->own()), eds::standard_name(list)),
                               "", std::move(related));
    }
}

void check_list_choice(const Context& context) {
    for (const Listed& each : context.model.listed()) {
        const SectionKind right = list_for(each.index);
        if (right != each.list) {
            context.reading.report(
                rules::eds_wrong_list, context.document.value_span(each.line),
                fmt::format("{} belongs into [{}]", object_text(each.index), eds::standard_name(right)));
        }
    }
}

void check_mandatory_objects(const Context& context) {
    const auto list = context.sheet.sections.find(SectionKind::mandatory_objects);
    for (const std::uint16_t index : {std::uint16_t{0x1000}, std::uint16_t{0x1001}, std::uint16_t{0x1018}}) {
        if (context.model.find(index) != nullptr) {
            continue;
        }
        const std::string message =
            fmt::format("{} is missing, which every CANopen device has", object_text(index));
        if (list) {
            context.reading.report(rules::eds_mandatory_object, context.header_of(*list), message);
        } else {
            context.reading.report_whole_file(rules::eds_mandatory_object, message);
        }
    }
}

}  // namespace cgw::eds_check
