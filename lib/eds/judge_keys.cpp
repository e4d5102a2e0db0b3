// Keys that come in any number: entries of lists, comments, dummies, bit rates. Each stands there once, and
// the numbers of lists are numbers.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/ascii.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds.hpp"
#include "eds/reading.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;

constexpr std::size_t most_digits = 9;

// The keys of all others are known by name, and key_lines() looks at them.
constexpr std::uint32_t bit_of(SectionKind kind) {
    return std::uint32_t{1} << static_cast<unsigned>(kind);
}
constexpr std::uint32_t with_known_keys =
    bit_of(SectionKind::unknown) | bit_of(SectionKind::tools) | bit_of(SectionKind::file_info) |
    bit_of(SectionKind::commissioning) | bit_of(SectionKind::object) | bit_of(SectionKind::sub_object) |
    bit_of(SectionKind::module_info) | bit_of(SectionKind::module_sub_extension);

bool has_free_keys(SectionKind kind) {
    return (with_known_keys & bit_of(kind)) == 0;
}

bool is_object_list(SectionKind kind) {
    return kind == SectionKind::mandatory_objects || kind == SectionKind::optional_objects ||
           kind == SectionKind::manufacturer_objects || kind == SectionKind::module_fixed_objects ||
           kind == SectionKind::module_sub_extends;
}

bool is_entry(const Reading& reading, std::uint32_t line) {
    return reading.document.lines()[line].kind == LineKind::entry;
}

// Of [DeviceInfo] the bit rates only.
bool is_free_key(SectionKind kind, std::string_view key) {
    constexpr std::string_view bit_rate = "BaudRate_";
    return kind != SectionKind::device_info ||
           (base::lower(key.front()) == 'b' &&
            base::equal_ignoring_case(key.substr(0, bit_rate.size()), bit_rate));
}

// A list as tools write it, 1=, 2=, 3=, or Line1=, Line2=, repeats nothing: nearly all of them need no more
// than this look.
bool counts_upwards(const Reading& reading, const Section& section, SectionKind kind) {
    std::string_view last_name;
    std::uint32_t last = 0;
    bool has_last = false;
    std::size_t others = 0;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        const std::string_view key = is_entry(reading, line) ? reading.document.key(line) : "";
        if (key.empty() || !is_free_key(kind, key)) {
            continue;
        }
        std::size_t begin = key.size();
        while (begin > 0 && base::is_digit(key[begin - 1])) {
            --begin;
        }
        if (begin == key.size()) {
            if (++others > 1) {
                return false;
            }
            continue;
        }
        const std::string_view name = key.substr(0, begin);
        if (key.size() - begin > most_digits || (has_last && name != last_name)) {
            return false;
        }
        std::uint32_t number = 0;
        for (const char c : key.substr(begin)) {
            number = number * 10 + static_cast<std::uint32_t>(c - '0');
        }
        if (has_last && number <= last) {
            return false;
        }
        last_name = name;
        last = number;
        has_last = true;
    }
    return true;
}

void judge_repeats(Reading& reading, const Section& section, SectionKind kind) {
    const Document& document = reading.document;
    std::vector<std::uint32_t> lines;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (is_entry(reading, line) && !document.key(line).empty() && is_free_key(kind, document.key(line))) {
            lines.push_back(line);
        }
    }
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return base::less_ignoring_case(document.key(a), document.key(b));
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

// 0x1018, as nearly every tool writes it.
bool is_usual_index(std::string_view text) {
    constexpr std::size_t length = 6;
    return text.size() == length && text[0] == '0' && text[1] == 'x' &&
           std::all_of(text.begin() + 2, text.end(), base::is_hexadecimal_digit);
}

// Numbers upwards with a usual index each, and SupportedObjects in front: most lists, and nothing to judge.
bool is_usual_list(const Document& document, const Section& section) {
    const std::string_view text = document.text();
    std::uint32_t last = 0;
    bool counted = false;
    for (std::uint32_t number = section.header + 1; number < section.end; ++number) {
        const Line& line = document.lines()[number];
        if (line.kind != LineKind::entry) {
            continue;
        }
        const std::string_view key = text.substr(line.begin, line.mark - line.begin);
        const std::string_view value = text.substr(line.mark + 1, line.end - line.mark - 1);
        if (!counted && key == "SupportedObjects" && value.size() <= most_digits &&
            base::consists_of(value, base::digits)) {
            counted = true;
            continue;
        }
        std::uint32_t place = 0;
        for (const char c : key) {
            if (!base::is_digit(c) || key.size() > most_digits) {
                return false;
            }
            place = place * 10 + static_cast<std::uint32_t>(c - '0');
        }
        if (place <= last || !is_usual_index(value)) {
            return false;
        }
        last = place;
    }
    return true;
}

// Readers pass over what is no number, and importers stop there.
void judge_list_values(Reading& reading, const Section& section) {
    const Document& document = reading.document;
    for (std::uint32_t line = section.header + 1; line < section.end; ++line) {
        if (!is_entry(reading, line) || is_usual_index(document.value(line))) {
            continue;
        }
        const bool is_count = base::equal_ignoring_case(document.key(line), "SupportedObjects");
        if (!is_count && !reading.entry_number(line)) {
            continue;
        }
        if (document.value(line).empty()) {
            reading.report(rules::eds_value, document.value_span(line),
                           fmt::format("{} of {} is empty", base::printable(document.key(line)),
                                       reading.quoted(section)));
        } else {
            reading.number(line, is_count ? highest_u32 : highest_u16);
        }
    }
}

// The key that says how many entries a section has, where no reader looks at it; "" for other sections.
std::string_view count_key(SectionKind kind) {
    switch (kind) {
        case SectionKind::names:
        case SectionKind::values:
        case SectionKind::denotations:
        case SectionKind::supported_modules:
        case SectionKind::connected_modules:
        case SectionKind::module_fixed_objects:
        case SectionKind::module_sub_extends:
            return "NrOfEntries";
        case SectionKind::comments:
        case SectionKind::module_comments:
            return "Lines";
        case SectionKind::object_links:
            return "ObjectLinks";
        default:
            return "";
    }
}

}  // namespace

void judge_free_keys(Reading& reading) {
    for (std::uint32_t number = 0; number < reading.document.sections().size(); ++number) {
        const SectionName& name = reading.sections.name(number);
        const SectionKind kind = name.kind;
        if (!has_free_keys(kind)) {
            continue;
        }
        const Section& section = reading.section(number);
        if (is_object_list(kind) && is_usual_list(reading.document, section)) {
            continue;
        }
        if (const std::string_view key = count_key(kind); !key.empty()) {
            reading.number(reading.document.find(section, key).value_or(0), highest_u16);
        }
        if (!counts_upwards(reading, section, kind)) {
            judge_repeats(reading, section, kind);
        }
        if (is_object_list(kind) && reading.sections.find({.kind = kind, .module = name.module}) == number) {
            judge_list_values(reading, section);
        }
    }
}

}  // namespace cgw::eds
