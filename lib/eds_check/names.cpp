// Sections and keys: their spelling, which ones there are, which ones there must be.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds/words.hpp"
#include "eds_check/context.hpp"
#include "eds_check/subjects.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using eds::SectionKind;
using eds::SectionName;

// [1018sub01]: digits behind "sub".
constexpr std::size_t sub_digits_at = 7;

bool is_tool_section(std::string_view name) {
    constexpr std::string_view prefix = "Tool";
    return base::equal_ignoring_case(name.substr(0, prefix.size()), prefix) &&
           base::consists_of(name.substr(std::min(prefix.size(), name.size())), base::digits);
}

// Of a key that the reader takes for another, with a finding of its own (eds-spelling).
bool is_read_as_another(SectionKind kind, std::string_view key) {
    return kind == SectionKind::device_info &&
           std::any_of(eds::misspelt_device_keys.begin(), eds::misspelt_device_keys.end(),
                       [key](const eds::MisspeltKey& each) {
                           return each.written.size() == key.size() &&
                                  base::equal_ignoring_case(each.written, key);
                       });
}

// Keys without number that a section could have and does not.
std::vector<std::string_view> absent_keys(const Context& context, const eds::Section& section,
                                          SectionKind kind) {
    std::vector<std::string_view> absent;
    for (const KeyRow& row : rows_of(kind)) {
        if (row.tail == Tail::none && !context.document.find(section, row.name)) {
            absent.push_back(row.name);
        }
    }
    return absent;
}

// Calls `take(section, line, near)` for each key that its section does not have; `near`: the key that it most
// probably is, one that the section lacks, or "".
template <typename Take>
void for_each_unknown_key(const Context& context, Take take) {
    constexpr std::size_t longest_key = 64;
    std::size_t searches = 1000;  // that are done; no file makes this slow
    std::optional<std::uint32_t> current;
    std::vector<std::string_view> absent;  // of the current section
    for_each_entry(context, [&](std::uint32_t number, std::uint32_t line) {
        const SectionKind kind = context.kind_of(number);
        const std::string_view key = context.document.key(line);
        if (context.model.key_row(line) != nullptr || rows_of(kind).empty() ||
            is_read_as_another(kind, key)) {
            return;
        }
        const eds::Section& section = context.reading.section(number);
        if (current != number) {
            current = number;
            absent = absent_keys(context, section, kind);
        }
        const bool is_searched = key.size() <= longest_key && searches > 0;
        searches -= is_searched ? 1 : 0;
        take(section, line, is_searched ? base::nearest_name(key, absent) : std::string());
    });
}

std::string quoted_key(const Context& context, std::uint32_t line) {
    constexpr std::size_t longest = 60;
    const std::string_view key = context.document.key(line);
    return key.empty() ? "an entry without a name" : base::printable(key.substr(0, longest));
}

// What it says is in the case of the standard, but for digits of indices.
bool is_spelt_as_printed(std::string_view name, const SectionName& parsed) {
    if (const std::string_view standard = eds::standard_name(parsed.kind); !standard.empty()) {
        return name == standard || parsed.misspelt;
    }
    return parsed.kind != SectionKind::sub_object || name.find("sub") != std::string_view::npos;
}

}  // namespace

void check_section_case(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        const SectionName& parsed = context.sheet.sections.name(number);
        if (!is_spelt_as_printed(context.document.name(sections[number]), parsed)) {
            const std::string_view standard = eds::standard_name(parsed.kind);
            context.reading.report(rules::eds_section_case, context.header_of(number),
                                   standard.empty()
                                       ? fmt::format("{}: CiA 306 writes sub in lower case",
                                                     context.reading.quoted(sections[number]))
                                       : fmt::format("{}: CiA 306 writes [{}]",
                                                     context.reading.quoted(sections[number]), standard));
        }
    }
}

void check_sub_zeros(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        const SectionName& parsed = context.sheet.sections.name(number);
        const std::string_view name = context.document.name(sections[number]);
        if (parsed.kind == SectionKind::sub_object && parsed.module == 0 &&
            name.size() == sub_digits_at + 2 && name[sub_digits_at] == '0') {
            context.reading.report(
                rules::eds_sub_zero, context.header_of(number),
                fmt::format("{}: a sub-index has no leading 0", context.reading.quoted(sections[number])));
        }
    }
}

void check_unknown_sections(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        if (context.kind_of(number) == SectionKind::unknown &&
            !is_tool_section(context.document.name(sections[number]))) {
            context.reading.report(
                rules::eds_section_unknown, context.header_of(number),
                fmt::format("{} is no section of CiA 306", context.reading.quoted(sections[number])));
        }
    }
}

void check_key_case(const Context& context) {
    for_each_entry(context, [&](std::uint32_t, std::uint32_t line) {
        const KeyRow* const row = context.model.key_row(line);
        const std::string_view key = context.document.key(line);
        if (row != nullptr && !is_spelt_as(*row, key)) {
            context.reading.report(rules::eds_key_case, context.document.key_span(line),
                                   fmt::format("{}: CiA 306 writes {}{}", quoted_key(context, line),
                                               row->name, key.substr(row->name.size())));
        }
    });
}

void check_misspelt_keys(const Context& context) {
    for_each_unknown_key(context, [&](const eds::Section& section, std::uint32_t line, const auto& near) {
        if (!near.empty()) {
            context.reading.report(
                rules::eds_key_misspelt, context.document.key_span(line),
                fmt::format("{} is no key of {}, and {} is missing", quoted_key(context, line),
                            context.reading.quoted(section), near),
                fmt::format("did you mean {}?", near));
        }
    });
}

void check_unknown_keys(const Context& context) {
    for_each_unknown_key(context, [&](const eds::Section& section, std::uint32_t line, const auto& near) {
        if (near.empty()) {
            context.reading.report(rules::eds_key_unknown, context.document.key_span(line),
                                   fmt::format("{} is no key of {}", quoted_key(context, line),
                                               context.reading.quoted(section)));
        }
    });
}

void check_absent_sections(const Context& context) {
    for (const SectionKind kind :
         {SectionKind::file_info, SectionKind::device_info, SectionKind::mandatory_objects}) {
        if (!context.sheet.sections.find(kind)) {
            context.reading.report_whole_file(rules::eds_section_absent,
                                              fmt::format("[{}] is missing", eds::standard_name(kind)));
        }
    }
}

void check_absent_keys(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        std::string absent;
        for (const KeyRow& row : rows_of(context.kind_of(number))) {
            // Empty is missing.
            const auto line = row.required ? context.document.find(sections[number], row.name) : std::nullopt;
            if (row.required && (!line || context.document.value(*line).empty())) {
                absent += absent.empty() ? "" : ", ";
                absent += row.name;
            }
        }
        if (!absent.empty()) {
            context.reading.report(
                rules::eds_keys_absent, context.header_of(number),
                fmt::format("{} lacks {}", context.reading.quoted(sections[number]), absent));
        }
    }
}

// CiA 306 has LastEDS and ConnectedModules in configuration files only.
void check_absent_commissioning(const Context& context) {
    constexpr std::string_view suffix = ".dcf";
    if (context.sheet.sections.find(SectionKind::commissioning)) {
        return;
    }
    const std::string_view name = context.options.file_name;
    const std::uint32_t last_eds = context.line_of(SectionKind::file_info, "LastEDS");
    const auto modules = context.sheet.sections.find(SectionKind::connected_modules);
    if (context.stated(last_eds)) {
        context.reading.report(
            rules::eds_commissioning_absent, context.document.key_span(last_eds),
            "LastEDS stands in configuration files, and no [DeviceComissioning] says of which node");
    } else if (modules) {
        context.reading.report(rules::eds_commissioning_absent, context.header_of(*modules),
                               "modules are connected to a node, and no [DeviceComissioning] says to which");
    } else if (name.size() > suffix.size() &&
               base::equal_ignoring_case(name.substr(name.size() - suffix.size()), suffix)) {
        context.reading.report_whole_file(
            rules::eds_commissioning_absent,
            "a .dcf is the configuration of one node, and [DeviceComissioning] is missing");
    }
}

void check_both_commissionings(const Context& context) {
    const std::span<const eds::Section> sections = context.document.sections();
    std::optional<std::uint32_t> first;
    for (std::uint32_t number = 0; number < sections.size(); ++number) {
        if (context.kind_of(number) != SectionKind::commissioning) {
            continue;
        }
        if (first && !context.document.same_name(*first, number)) {
            context.reading.report(
                rules::eds_commissioning_twice, context.header_of(number),
                fmt::format("{} stands in the file as well as {}", context.reading.quoted(sections[number]),
                            context.reading.quoted(sections[*first])),
                "", {{context.reading.location(context.header_of(*first)), "the one that is read"}});
        }
        first = first ? first : number;
    }
}

}  // namespace cgw::eds_check
