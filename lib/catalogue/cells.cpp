#include "catalogue/cells.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "catalogue/cell_readers.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Row;
using parameter::Scaling;

std::string quoted(std::string_view text) {
    return fmt::format("\"{}\"", text);
}
std::string truth(bool value) {
    return value ? "true" : "false";
}

std::string pair_text(double low, double high) {
    return fmt::format("[{}, {}]", base::to_text(low), base::to_text(high));
}

std::string limit_text(std::optional<double> constant, std::uint16_t reference) {
    if (reference != 0) {
        return fmt::format("{{ parameter = {} }}", reference);
    }
    return constant ? base::to_text(*constant) : "?";
}

Scaling& scaling_of(Row& row) {
    return row.scaling ? *row.scaling : row.scaling.emplace();
}

// how finished rows compare and merge

bool never_blank(const Row&) {
    return false;
}
bool always_blank(const Row&) {
    return true;
}
void copy_nothing(const Row&, Row&) {}
bool blank_width(const Row& row) {
    return row.width == 0;
}
bool blank_range(const Row& row) {
    return !row.minimum && !row.maximum;
}

bool blank_internal(const Row& row) {
    return !row.scaling || row.scaling->internal_minimum == row.scaling->internal_maximum;
}

bool blank_external(const Row& row) {
    return !row.scaling ||
           (!row.scaling->external_minimum && !row.scaling->external_maximum &&
            row.scaling->external_minimum_parameter == 0 && row.scaling->external_maximum_parameter == 0);
}

std::string show_internal(const Row& row) {
    return row.scaling ? pair_text(row.scaling->internal_minimum, row.scaling->internal_maximum) : "";
}

std::string show_external(const Row& row) {
    if (!row.scaling) {
        return "";
    }
    const Scaling& scaling = *row.scaling;
    return fmt::format("[{}, {}]", limit_text(scaling.external_minimum, scaling.external_minimum_parameter),
                       limit_text(scaling.external_maximum, scaling.external_maximum_parameter));
}

void copy_internal(const Row& from, Row& to) {
    if (from.scaling) {
        scaling_of(to).internal_minimum = from.scaling->internal_minimum;
        scaling_of(to).internal_maximum = from.scaling->internal_maximum;
    }
}

void copy_external(const Row& from, Row& to) {
    if (from.scaling) {
        Scaling merged = *from.scaling;
        merged.internal_minimum = scaling_of(to).internal_minimum;
        merged.internal_maximum = scaling_of(to).internal_maximum;
        to.scaling = merged;
    }
}

void copy_range(const Row& from, Row& to) {
    to.minimum = from.minimum;
    to.maximum = from.maximum;
}

template <auto Member>
void copy(const Row& from, Row& to) {
    to.*Member = from.*Member;
}

template <auto Member>
bool is_empty(const Row& row) {
    return (row.*Member).empty();
}

template <auto Member>
std::string show_text(const Row& row) {
    return quoted(row.*Member);
}

template <auto Member>
std::string show_list(const Row& row) {
    return fmt::format("[{}]", fmt::join(row.*Member, ", "));
}

template <auto Member>
std::string show_truth(const Row& row) {
    return truth(row.*Member);
}

std::string show_width(const Row& row) {
    return fmt::format("{}", row.width);
}
std::string show_bit(const Row& row) {
    return truth(row.is_bit());
}
std::string show_range(const Row& row) {
    return pair_text(row.minimum.value_or(0), row.maximum.value_or(0));
}
std::string show_level(const Row& row) {
    return fmt::format("{}", row.level);
}

std::string show_base(const Row& row) {
    return row.base == parameter::Base::hexadecimal ? "\"hexadecimal\"" : "\"decimal\"";
}

std::string show_bits(const Row& row) {
    std::string shown;
    for (const parameter::NamedBit& bit : row.bits) {
        shown += fmt::format("{}{} {}", shown.empty() ? "" : ", ", bit.bit, bit.name);
    }
    return shown;
}

std::string show_values(const Row& row) {
    std::string shown;
    for (const parameter::NamedValue& value : row.values) {
        shown += fmt::format("{}{}: {}", shown.empty() ? "" : ", ", value.value, value.text);
    }
    return shown;
}

using enum toml::Kind;

// Texts are no facts: a later one replaces an earlier one.
constexpr Cell cells[] = {
    {"number", integer, true, false, read_number, nullptr, nullptr, nullptr},
    {"count", integer, false, false, read_count, nullptr, nullptr, nullptr},
    {"last", integer, false, false, read_last, nullptr, nullptr, nullptr},
    {"list_end", integer, false, false, read_list_end, nullptr, nullptr, nullptr},
    {"name", string, true, false, read_name, is_empty<&Row::name>, show_text<&Row::name>, copy<&Row::name>},
    {"aliases", array, false, false, read_aliases, is_empty<&Row::aliases>, show_list<&Row::aliases>,
     copy<&Row::aliases>},
    {"misprints", array, false, false, read_misprints, is_empty<&Row::misprints>, show_list<&Row::misprints>,
     copy<&Row::misprints>},
    {"kind", string, true, false, read_kind, nullptr, nullptr, nullptr},
    {"level", integer, false, false, read_level, [](const Row& row) { return row.level == 0; }, show_level,
     copy<&Row::level>},
    {"range", array, false, false, read_range, blank_range, show_range, copy_range},
    {"choices", array, false, false, read_choices, is_empty<&Row::choices>, show_list<&Row::choices>,
     copy<&Row::choices>},
    {"unit", string, true, false, read_unit, is_empty<&Row::unit>, show_text<&Row::unit>, copy<&Row::unit>},
    {"base", string, false, false, read_base, never_blank, show_base, copy_nothing},
    {"decimal", boolean, false, false, read_decimal, never_blank, show_truth<&Row::decimal>, copy_nothing},
    {"width", integer, true, true, read_width, blank_width, show_width, copy<&Row::width>},
    {"bit", boolean, true, true, read_bit, blank_width, show_bit, copy<&Row::width>},
    {"signed", boolean, true, true, read_signed, blank_width, show_truth<&Row::is_signed>,
     copy<&Row::is_signed>},
    {"internal", array, true, true, read_internal, blank_internal, show_internal, copy_internal},
    {"external", array, true, true, read_external, blank_external, show_external, copy_external},
    {"bits", array, false, false, read_bits, is_empty<&Row::bits>, show_bits, copy<&Row::bits>},
    {"values", array, false, false, read_values, is_empty<&Row::values>, show_values, copy<&Row::values>},
    {"text", string, false, false, read_text, always_blank, show_text<&Row::text>, copy<&Row::text>},
    {"used", string, false, false, read_used, always_blank, show_text<&Row::used>, copy<&Row::used>},
    {"section", string, false, false, read_section, always_blank, show_text<&Row::section>,
     copy<&Row::section>},
    {"pages", array, false, false, read_pages, always_blank, show_list<&Row::pages>, copy<&Row::pages>},
};

}  // namespace

void Reporter::operator()(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                          std::string help) const {
    findings_.report({&rule, std::move(message), at(where), {}, std::move(help)});
}

bool Draft::refuses(std::string_view cell) const {
    return std::find(refused.begin(), refused.end(), cell) != refused.end();
}

const diagnostic::Range& Draft::where(std::string_view cell) const {
    const toml::Entry* entry = table.find(cell);
    return entry != nullptr ? entry->value.range : table.range;
}

std::span<const Cell> all_cells() {
    return cells;
}

}  // namespace cgw::catalogue
