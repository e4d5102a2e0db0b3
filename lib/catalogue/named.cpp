#include "catalogue/named.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "base/edit_distance.hpp"
#include "catalogue/templates.hpp"
#include "catalogue/values.hpp"
#include "diagnostic/rules/keys.hpp"

namespace cgw::catalogue {

namespace {

using parameter::NamedBit;
using parameter::NamedValue;
using toml::Node;
namespace rules = diagnostic::rules;

constexpr std::int64_t highest_bit = 31;

// An inline table with known keys only; false after a finding.
bool check_keys(const Node& table, std::span<const std::string_view> known, const Reporter& report) {
    if (table.kind != toml::Kind::table) {
        report(rules::key_type, table.range,
               fmt::format("an element is a table, not {}", toml::to_text(table.kind)));
        return false;
    }
    for (const toml::Entry& entry : table.entries) {
        if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
            const std::string near = base::nearest_name(entry.key, known);
            report(rules::key_unknown, entry.key_range,
                   fmt::format("unknown key {}", toml::quoted(entry.key)),
                   near.empty() ? "" : fmt::format("did you mean `{}`?", near));
            return false;
        }
    }
    return true;
}

// A text that must be there and be one line; empty after a finding.
std::string_view line_of(const Node& table, std::string_view key, const Reporter& report) {
    const toml::Entry* entry = table.find(key);
    if (entry != nullptr && entry->value.kind == toml::Kind::string && is_line(entry->value.text)) {
        return entry->value.text;
    }
    report(rules::declaration_invalid, entry != nullptr ? entry->value.range : table.range,
           fmt::format("`{}` is a text of one line", key));
    return {};
}

std::optional<std::int64_t> integer_of(const Node& table, std::string_view key, std::int64_t highest,
                                       const Reporter& report) {
    const toml::Entry* entry = table.find(key);
    if (entry != nullptr && entry->value.kind == toml::Kind::integer && entry->value.integer >= 0 &&
        entry->value.integer <= highest) {
        return entry->value.integer;
    }
    report(rules::declaration_invalid, entry != nullptr ? entry->value.range : table.range,
           fmt::format("`{}` is an integer from 0 to {}", key, highest));
    return std::nullopt;
}

}  // namespace

std::vector<NamedBit> named_bits(const Node& value, std::deque<std::string>& texts, const Reporter& report) {
    constexpr std::string_view known[] = {"bit", "last", "name", "text"};
    std::vector<NamedBit> bits;
    for (const Node& table : value.elements) {
        if (!check_keys(table, known, report)) {
            continue;
        }
        const auto first = integer_of(table, "bit", highest_bit, report);
        const auto last =
            table.find("last") != nullptr ? integer_of(table, "last", highest_bit, report) : first;
        const std::string_view name = line_of(table, "name", report);
        const std::string_view text = line_of(table, "text", report);
        if (!first || !last || name.empty() || text.empty()) {
            continue;
        }
        if (*last < *first || (!bits.empty() && bits.back().bit >= *first)) {
            report(rules::declaration_invalid, table.range, "bits ascend, each one once");
            continue;
        }
        for (std::int64_t bit = *first; bit <= *last; ++bit) {
            const auto offset = static_cast<std::uint32_t>(bit - *first);
            const std::string& full_name = texts.emplace_back(expand_text(name, offset));
            const std::string& full_text = texts.emplace_back(expand_text(text, offset));
            if (!is_name(full_name)) {
                report(rules::declaration_invalid, table.range,
                       fmt::format("{} is no name for a bit", toml::quoted(full_name)));
                break;
            }
            bits.push_back({static_cast<std::uint8_t>(bit), full_name, full_text});
        }
    }
    return bits;
}

std::vector<NamedValue> named_values(const Node& value, const Reporter& report) {
    constexpr std::string_view known[] = {"value", "text"};
    std::vector<NamedValue> values;
    for (const Node& table : value.elements) {
        if (!check_keys(table, known, report)) {
            continue;
        }
        const auto number = integer_of(table, "value", std::numeric_limits<std::uint32_t>::max(), report);
        const std::string_view text = line_of(table, "text", report);
        if (!number || text.empty()) {
            continue;
        }
        if (!values.empty() && values.back().value >= *number) {
            report(rules::declaration_invalid, table.range, "values ascend, each one once");
            continue;
        }
        values.push_back({static_cast<std::uint32_t>(*number), text});
    }
    return values;
}

}  // namespace cgw::catalogue
