// Keys that come in any number: entries of lists, comments, dummies, bit rates. Each stands there once, and
// the numbers of lists are numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds.hpp"
#include "eds/reading.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;

// The keys of all others are known by name, and key_lines() looks at them.
bool has_free_keys(SectionKind kind) {
    constexpr std::array others{SectionKind::unknown,     SectionKind::tools,
                                SectionKind::file_info,   SectionKind::commissioning,
                                SectionKind::object,      SectionKind::sub_object,
                                SectionKind::module_info, SectionKind::module_sub_extension};
    return std::find(others.begin(), others.end(), kind) == others.end();
}

bool is_object_list(SectionKind kind) {
    return kind == SectionKind::mandatory_objects || kind == SectionKind::optional_objects ||
           kind == SectionKind::manufacturer_objects;
}

bool is_entry(const Reading& reading, std::uint32_t line) {
    return reading.document.lines()[line].kind == LineKind::entry;
}

// Of [DeviceInfo] the bit rates only.
bool is_free_key(SectionKind kind, std::string_view key) {
    constexpr std::string_view bit_rate = "BaudRate_";
    return kind != SectionKind::device_info ||
           base::equal_ignoring_case(key.substr(0, bit_rate.size()), bit_rate);
}

// A list as tools write it, 1=, 2=, 3=, repeats nothing: nearly all of them need no more than this look.
bool counts_upwards(const Reading& reading, const Section& section) {
    std::uint32_t last = 0;
    std::size_t others = 0;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        const auto number = reading.entry_number(line);
        if (number && *number <= last) {
            return false;
        }
        last = number.value_or(last);
        others += !number && is_entry(reading, line) ? 1U : 0U;
    }
    return others <= 1;
}

void judge_repeats(Reading& reading, const Section& section, SectionKind kind) {
    const Document& document = reading.document;
    std::vector<std::uint32_t> lines;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (is_entry(reading, line) && is_free_key(kind, document.key(line))) {
            lines.push_back(line);
        }
    }
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const std::string_view x = document.key(a);
        const std::string_view y = document.key(b);
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(),
                                            [](char c, char d) { return base::lower(c) < base::lower(d); });
    };
    std::stable_sort(lines.begin(), lines.end(), before);
    std::size_t first = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (before(lines[first], lines[i])) {
            first = i;
            continue;
        }
        reading.report(rules::eds_key_twice, document.key_span(lines[i]),
                       fmt::format("{} stands in {} already", base::printable(document.key(lines[i])),
                                   reading.quoted(section)),
                       "", {{reading.location(document.key_span(lines[first])), "the first one"}});
    }
}

// Readers pass over what is no number, and importers stop there.
void judge_list_values(Reading& reading, const Section& section) {
    const Document& document = reading.document;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        const bool numbered = reading.entry_number(line).has_value();
        if (!numbered &&
            !(is_entry(reading, line) && base::equal_ignoring_case(document.key(line), "SupportedObjects"))) {
            continue;
        }
        if (document.value(line).empty()) {
            reading.report(rules::eds_value, document.value_span(line),
                           fmt::format("{} of {} is empty", base::printable(document.key(line)),
                                       reading.quoted(section)));
        } else {
            reading.number(line, highest_u16);
        }
    }
}

}  // namespace

void judge_free_keys(Reading& reading) {
    for (std::uint32_t number = 0; number < reading.document.sections().size(); ++number) {
        const SectionKind kind = reading.sections.name(number).kind;
        if (!has_free_keys(kind)) {
            continue;
        }
        const Section& section = reading.section(number);
        if (!counts_upwards(reading, section)) {
            judge_repeats(reading, section, kind);
        }
        if (is_object_list(kind) && reading.sections.find(kind) == number) {
            judge_list_values(reading, section);
        }
    }
}

}  // namespace cgw::eds
