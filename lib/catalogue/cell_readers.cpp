#include "catalogue/cell_readers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "catalogue/kinds.hpp"
#include "catalogue/named.hpp"
#include "catalogue/values.hpp"
#include "diagnostic/rules/keys.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Scaling;
using toml::Node;
namespace rules = diagnostic::rules;

Scaling& scaling_of(parameter::Row& row) {
    return row.scaling ? *row.scaling : row.scaling.emplace();
}

std::string_view read_line(const Node& value, const Reporter& report) {
    if (is_line(value.text)) {
        return value.text;
    }
    report(rules::declaration_invalid, value.range, "the text is empty or has control characters");
    return {};
}

void report_bad_name(const Node& value, const Reporter& report) {
    report(rules::declaration_invalid, value.range,
           fmt::format("{} is no name: it starts with a letter, has up to {} letters, digits and _ - : . /",
                       toml::quoted(value.text), longest_name));
}

// A word that is no kind, or a kind whose numbers are others.
void report_bad_kind(const Node& value, const Draft& draft, const Reporter& report) {
    std::string numbers;
    bool known = false;
    for (const Kind& kind : all_kinds()) {
        if (kind.name == value.text) {
            known = true;
            numbers += fmt::format("{}{}..{}", numbers.empty() ? "" : " and ", kind.first, kind.last);
        }
    }
    if (!known) {
        report(rules::key_value, value.range, fmt::format("unknown kind {}", toml::quoted(value.text)),
               "kinds are parameter, measurement, function, curve, switch, sensor");
    } else if (draft.row.number != 0) {
        report(rules::declaration_invalid, value.range,
               fmt::format("{} is no {}: its numbers are {} of the governor", draft.row.number, value.text,
                           numbers));
    }
}

std::vector<std::uint32_t> read_numbers(const Node& value, std::string_view demand, const Reporter& report) {
    std::vector<std::uint32_t> numbers;
    for (const Node& element : value.elements) {
        if (element.kind != toml::Kind::integer || element.integer < 0 ||
            element.integer > std::numeric_limits<std::uint32_t>::max()) {
            report(rules::declaration_invalid, element.range, std::string(demand));
        } else {
            numbers.push_back(static_cast<std::uint32_t>(element.integer));
        }
    }
    return numbers;
}

}  // namespace

// number, count, last, list_end

void read_number(const Node& value, Draft& draft, const Reporter& report) {
    if (value.integer < 1 || value.integer > highest_number) {
        report(rules::declaration_invalid, value.range,
               fmt::format("number {} is outside 1..{}", value.text, highest_number));
        return;
    }
    draft.row.number = static_cast<std::uint16_t>(value.integer);
}

void read_count(const Node& value, Draft& draft, const Reporter& report) {
    const std::int64_t most = highest_number - draft.row.number + 1;
    if (value.integer < 2 || value.integer > most) {
        report(rules::declaration_invalid, value.range,
               fmt::format("an array has 2 elements or more and ends by {}", highest_number));
        return;
    }
    draft.count = static_cast<std::uint16_t>(value.integer);
}

void read_last(const Node& value, Draft& draft, const Reporter& report) {
    if (value.integer < draft.row.number || value.integer > highest_number) {
        report(rules::declaration_invalid, value.range,
               fmt::format("last {} is outside {}..{}", value.text, draft.row.number, highest_number));
        return;
    }
    draft.last = static_cast<std::uint16_t>(value.integer);
}

void read_list_end(const Node& value, Draft& draft, const Reporter& report) {
    if (value.integer < draft.row.number || value.integer > highest_number) {
        report(rules::declaration_invalid, value.range,
               fmt::format("list_end {} is outside {}..{}", value.text, draft.row.number, highest_number));
        return;
    }
    draft.row.list_end = static_cast<std::uint16_t>(value.integer);
}

// name and texts

void read_name(const Node& value, Draft& draft, const Reporter& report) {
    if (is_name(value.text)) {
        draft.row.name = value.text;
    } else {
        report_bad_name(value, report);
    }
}

void read_aliases(const Node& value, Draft& draft, const Reporter& report) {
    for (const Node& element : value.elements) {
        if (element.kind != toml::Kind::string) {
            report(rules::key_type, element.range,
                   fmt::format("an alias is a string, not {}", toml::to_text(element.kind)));
        } else if (is_name(element.text)) {
            draft.aliases.emplace_back(element.text);
        } else {
            report_bad_name(element, report);
        }
    }
    draft.row.aliases = draft.aliases;
}

void read_misprints(const Node& value, Draft& draft, const Reporter& report) {
    for (const Node& element : value.elements) {
        if (element.kind == toml::Kind::string && is_number_and_name(element.text)) {
            draft.misprints.emplace_back(element.text);
        } else {
            report(rules::declaration_invalid, element.range,
                   "a misprint is a string of a number and a name: \"409 CanBaudrate\"");
        }
    }
    draft.row.misprints = draft.misprints;
}

void read_kind(const Node& value, Draft& draft, const Reporter& report) {
    if (const Kind* kind = find_kind(value.text, draft.row.device, draft.row.number); kind != nullptr) {
        draft.row.list = kind->list;
        draft.row.role = kind->role;
        if (kind->ranged) {
            draft.row.minimum = kind->minimum;
            draft.row.maximum = kind->maximum;
        }
        draft.kind_known = true;
        return;
    }
    report_bad_kind(value, draft, report);
}

void read_text(const Node& value, Draft& draft, const Reporter& report) {
    draft.row.text = read_line(value, report);
}

void read_used(const Node& value, Draft& draft, const Reporter& report) {
    draft.row.used = read_line(value, report);
}

void read_bits(const Node& value, Draft& draft, const Reporter& report) {
    draft.bits = named_bits(value, draft.texts, report);
    draft.row.bits = draft.bits;
}

void read_values(const Node& value, Draft& draft, const Reporter& report) {
    draft.values = named_values(value, report);
    draft.row.values = draft.values;
}

void read_section(const Node& value, Draft& draft, const Reporter& report) {
    draft.row.section = read_line(value, report);
}

void read_unit(const Node& value, Draft& draft, const Reporter& report) {
    if (is_line(value.text) && value.text.size() <= longest_unit) {
        draft.row.unit = value.text;
    } else {
        report(rules::declaration_invalid, value.range,
               fmt::format("a unit has 1 to {} bytes and no control characters", longest_unit));
    }
}

// numbers

void read_level(const Node& value, Draft& draft, const Reporter& report) {
    constexpr std::int64_t highest = 7;
    if (value.integer < 1 || value.integer > highest) {
        report(rules::declaration_invalid, value.range, fmt::format("level {} is outside 1..7", value.text));
        return;
    }
    draft.row.level = static_cast<std::uint8_t>(value.integer);
}

void read_range(const Node& value, Draft& draft, const Reporter& report) {
    if (const auto pair = read_pair(value, "range", report)) {
        draft.row.minimum = pair->first;
        draft.row.maximum = pair->second;
    }
}

void read_choices(const Node& value, Draft& draft, const Reporter& report) {
    draft.choices = read_numbers(value, "a choice is an integer from 0 to 4294967295", report);
    draft.row.choices = draft.choices;
}

void read_pages(const Node& value, Draft& draft, const Reporter& report) {
    draft.pages = read_numbers(value, "a page is an integer from 0 to 4294967295", report);
    draft.row.pages = draft.pages;
}

void read_base(const Node& value, Draft& draft, const Reporter& report) {
    if (value.text == "hexadecimal") {
        draft.row.base = parameter::Base::hexadecimal;
    } else if (value.text != "decimal") {
        report(rules::key_value, value.range,
               fmt::format(R"(base {} is neither "decimal" nor "hexadecimal")", toml::quoted(value.text)));
    }
}

void read_decimal(const Node& value, Draft& draft, const Reporter&) {
    draft.row.decimal = value.boolean;
}

// what a measurement is on the wire

void read_width(const Node& value, Draft& draft, const Reporter& report) {
    if (std::find(word_widths.begin(), word_widths.end(), value.integer) != word_widths.end()) {
        draft.row.width = static_cast<std::uint8_t>(value.integer);
    } else {
        report(rules::declaration_invalid, value.range,
               fmt::format("width {} is neither {}", value.text, fmt::join(word_widths, " nor ")),
               value.integer == 1 ? "write `bit = true` for a measurement of one bit" : "");
    }
}

void read_bit(const Node& value, Draft& draft, const Reporter& report) {
    if (!value.boolean) {
        return;
    }
    if (draft.says("width") || draft.says("signed")) {
        report(rules::declaration_invalid, value.range, "a bit has neither width nor sign");
        return;
    }
    draft.row.width = 1;
}

void read_signed(const Node& value, Draft& draft, const Reporter&) {
    draft.row.is_signed = value.boolean;
}

void read_internal(const Node& value, Draft& draft, const Reporter& report) {
    const auto pair = read_pair(value, "internal", report);
    if (!pair) {
        return;
    }
    const bool whole = pair->first == std::floor(pair->first) && pair->second == std::floor(pair->second);
    if (!whole || pair->first < lowest_raw || pair->second > highest_raw || pair->first == pair->second) {
        report(rules::declaration_invalid, value.range,
               fmt::format("internal [{}, {}] is not a range of integers within {}..{}",
                           base::to_text(pair->first), base::to_text(pair->second), lowest_raw, highest_raw));
        return;
    }
    scaling_of(draft.row).internal_minimum = static_cast<std::int32_t>(pair->first);
    scaling_of(draft.row).internal_maximum = static_cast<std::int32_t>(pair->second);
}

void read_external(const Node& value, Draft& draft, const Reporter& report) {
    if (const auto limits = read_limits(value, report)) {
        Scaling& scaling = scaling_of(draft.row);
        scaling.external_minimum = limits->low.constant;
        scaling.external_maximum = limits->high.constant;
        scaling.external_minimum_parameter = limits->low.reference;
        scaling.external_maximum_parameter = limits->high.reference;
    }
}

}  // namespace cgw::catalogue
