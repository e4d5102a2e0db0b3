#include "catalogue/values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"

namespace cgw::catalogue {

namespace {

using toml::Node;
namespace rules = diagnostic::rules;

bool is_number(const Node& value) {
    return (value.kind == toml::Kind::integer || value.kind == toml::Kind::real) && std::isfinite(value.real);
}

bool has_two(const Node& value, std::string_view cell, const Reporter& report) {
    if (value.elements.size() == 2) {
        return true;
    }
    report(rules::declaration_invalid, value.range,
           fmt::format("`{}` has {} elements, not two: [lowest, highest]", cell, value.elements.size()));
    return false;
}

std::optional<Limit> read_limit(const Node& value, const Reporter& report) {
    if (is_number(value)) {
        return Limit{value.real, 0};
    }
    if (value.kind == toml::Kind::table) {
        const toml::Entry* entry = value.find("parameter");
        if (entry != nullptr && value.entries.size() == 1 && entry->value.kind == toml::Kind::integer &&
            entry->value.integer >= 1 && entry->value.integer <= highest_number) {
            return Limit{std::nullopt, static_cast<std::uint16_t>(entry->value.integer)};
        }
    }
    report(rules::declaration_invalid, value.range,
           "an external limit is a number or the parameter that holds it: { parameter = 980 }");
    return std::nullopt;
}

}  // namespace

bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= longest_name && base::is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return base::is_letter_or_digit(c) || name_marks.find(c) != std::string_view::npos;
           });
}

bool is_number_and_name(std::string_view text) {
    const std::size_t blank = text.find(' ');
    if (blank == std::string_view::npos) {
        return false;
    }
    const auto number = base::parse_integer(text.substr(0, blank));
    return number && *number >= 1 && *number <= highest_number && base::is_digit(text.front()) &&
           is_name(text.substr(blank + 1));
}

bool is_line(std::string_view text) {
    unsigned char before = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_c1_control = before == 0xC2 && byte < 0xA0;  // U+0080..U+009F in UTF-8
        if (byte < 0x20 || byte == 0x7F || is_c1_control) {
            return false;
        }
        before = byte;
    }
    return !text.empty();
}

std::optional<std::pair<double, double>> read_pair(const Node& value, std::string_view cell,
                                                   const Reporter& report) {
    if (!has_two(value, cell, report)) {
        return std::nullopt;
    }
    for (const Node& element : value.elements) {
        if (!is_number(element)) {
            report(rules::key_type, element.range,
                   fmt::format("a limit of `{}` is a number, not {}", cell, toml::to_text(element.kind)));
            return std::nullopt;
        }
    }
    const double low = value.elements[0].real;
    const double high = value.elements[1].real;
    if (low > high) {
        report(rules::declaration_invalid, value.range,
               fmt::format("`{}` runs backwards: {} is above {}", cell, base::to_text(low),
                           base::to_text(high)));
        return std::nullopt;
    }
    return std::pair(low, high);
}

std::optional<Limits> read_limits(const Node& value, const Reporter& report) {
    if (!has_two(value, "external", report)) {
        return std::nullopt;
    }
    const std::optional<Limit> low = read_limit(value.elements[0], report);
    const std::optional<Limit> high = read_limit(value.elements[1], report);
    if (!low || !high) {
        return std::nullopt;
    }
    if (low->constant && high->constant && *low->constant >= *high->constant) {
        report(rules::declaration_invalid, value.range,
               fmt::format("`external` does not ascend: {} to {}", base::to_text(*low->constant),
                           base::to_text(*high->constant)));
        return std::nullopt;
    }
    if (low->reference != 0 && low->reference == high->reference) {
        report(rules::declaration_invalid, value.range,
               fmt::format("`external` has parameter {} for both limits", low->reference));
        return std::nullopt;
    }
    return Limits{*low, *high};
}

}  // namespace cgw::catalogue
