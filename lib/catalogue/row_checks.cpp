#include "catalogue/row_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "catalogue/kinds.hpp"
#include "diagnostic/rules/keys.hpp"

namespace cgw::catalogue {

namespace {

using parameter::List;
using parameter::Row;
namespace rules = diagnostic::rules;

void require(std::string_view cell, const Row& row, const Draft& draft, const Reporter& report) {
    report(rules::key_missing, draft.table.range, fmt::format("`{}` of {} is missing", cell, row.number));
}

bool has_internal(const parameter::Scaling& scaling) {
    return scaling.internal_minimum != scaling.internal_maximum;
}

bool fits(const parameter::Scaling& scaling, unsigned width, bool is_signed) {
    const std::int32_t steps = std::int32_t{1} << width;
    const std::int32_t lowest = is_signed ? -steps / 2 : 0;
    return scaling.internal_minimum >= lowest && scaling.internal_maximum < lowest + steps;
}

// D13: what a TPDO carries is known with its width and sign. The gateway's own measurements are never sent.
// False when width or sign are missing, refused or contradicted, so that nothing is concluded from them.
bool check_width(const Row& row, const Row* known, const Draft& draft, const Reporter& report) {
    const bool sent = row.device == parameter::Device::governor;
    if (known != nullptr && known->width != 0) {
        const bool same_width = draft.row.width == 0 || draft.row.width == row.width;
        const bool same_sign =
            !draft.says("signed") || draft.refuses("signed") || draft.row.is_signed == row.is_signed;
        return same_width && same_sign;
    }
    if (draft.refuses("width") || draft.refuses("bit") || draft.refuses("signed")) {
        return false;
    }
    if (row.width == 0 && (sent || draft.says("signed"))) {
        require("width", row, draft, report);
        return false;
    }
    if (row.width > 1 && !draft.says("signed")) {
        require("signed", row, draft, report);
        return false;
    }
    return true;
}

void check_scaling(const Row& row, const Draft& draft, const Reporter& report) {
    if (!row.scaling || draft.refuses("internal")) {
        return;
    }
    const parameter::Scaling& scaling = *row.scaling;
    if (row.is_bit()) {
        const std::string_view cell = draft.says("internal") ? "internal" : "external";
        report(rules::declaration_invalid, draft.where(cell), fmt::format("a bit has no {} range", cell));
    } else if (!has_internal(scaling)) {
        require("internal", row, draft, report);
    } else if (row.width != 0 && !fits(scaling, row.width, row.is_signed)) {
        report(rules::declaration_invalid, draft.where("internal"),
               fmt::format("internal [{}, {}] does not fit {} bits, {}", scaling.internal_minimum,
                           scaling.internal_maximum, row.width, row.is_signed ? "signed" : "unsigned"));
    }
}

void check_settable(const Row& row, const Draft& draft, bool declaration, const Reporter& report) {
    for (const Cell& cell : all_cells()) {
        if (cell.of_measurement && draft.says(cell.name) && !draft.refuses(cell.name)) {
            report(rules::declaration_invalid, draft.where(cell.name),
                   fmt::format("`{}` describes measurements, and {} is a {}", cell.name, row.number,
                               kind_of(row)));
        }
    }
    if (declaration && row.name.empty() && !draft.says("name") && !draft.refuses("name")) {
        require("name", row, draft, report);
    }
    constexpr double largest = 0xFFFFFFFF;  // what is printed with eight hexadecimal digits
    const bool printable = row.minimum.value_or(-1) >= 0 && row.maximum.value_or(largest + 1) <= largest;
    if (row.base == parameter::Base::hexadecimal && !printable && !draft.refuses("range")) {
        report(rules::declaration_invalid, draft.where("base"),
               fmt::format("{} is hexadecimal: its range lies within 0..0xFFFFFFFF", row.number));
    }
}

void check_choices(const Row& row, const Draft& draft, const Reporter& report) {
    if (draft.refuses("range") || draft.refuses("choices")) {
        return;
    }
    for (const std::uint32_t choice : row.choices) {
        if (choice < row.minimum.value_or(choice) || choice > row.maximum.value_or(choice)) {
            report(rules::declaration_invalid, draft.where("choices"),
                   fmt::format("choice {} is outside the range of {}", choice, row.number));
        }
    }
}

void check_cells(const Row& row, const Row* known, const Draft& draft, bool declaration,
                 const Reporter& report) {
    if (row.list == List::measurement) {
        if (row.name.empty() && !draft.says("name") && !draft.refuses("name")) {
            require("name", row, draft, report);
        }
        if (check_width(row, known, draft, report)) {
            check_scaling(row, draft, report);
        }
    } else {
        check_settable(row, draft, declaration, report);
    }
    check_choices(row, draft, report);
}

// After a finding: a TPDO that carries the row has a width, and no scaling that does not fit is left.
void settle(Row& row) {
    constexpr std::uint8_t width_after_a_finding = 16;
    if (row.list == List::measurement && row.device == parameter::Device::governor && row.width == 0) {
        row.width = width_after_a_finding;
    }
    if (row.scaling && (row.is_bit() || !has_internal(*row.scaling) ||
                        (row.width != 0 && !fits(*row.scaling, row.width, row.is_signed)))) {
        row.scaling.reset();
    }
}

// The manuals' lists: 2000..3999 are measurements, and so are 12000..13999.
bool is_numbered_as_measurement(std::uint16_t number) {
    const int thousands = number / 1000 % 10;
    return thousands == 2 || thousands == 3;
}

}  // namespace

bool names_a_pair(const Draft& draft) {
    const toml::Entry* entry = draft.table.find("kind");
    return entry != nullptr && draft.refuses("kind") &&
           std::any_of(all_kinds().begin(), all_kinds().end(), [&](const Kind& kind) {
               return kind.role != parameter::Role::none && kind.name == entry->value.text;
           });
}

void stand_in(Row& row, const Draft& draft) {
    const bool described_as_measurement =
        std::any_of(all_cells().begin(), all_cells().end(),
                    [&](const Cell& cell) { return cell.of_measurement && draft.says(cell.name); });
    const bool is_measurement =
        !names_a_pair(draft) && (described_as_measurement || is_numbered_as_measurement(row.number));
    row.list = is_measurement ? List::measurement : List::parameter;
    row.decimal = true;
    settle(row);
}

void check_row(Row& row, const Row* known, const Draft& draft, bool declaration, const Reporter& report) {
    if (known == nullptr && !draft.kind_known) {
        if (!draft.says("kind") && !draft.refuses("kind")) {
            require("kind", row, draft, report);
        }
        stand_in(row, draft);
        return;
    }
    const bool contradicts_kind = draft.kind_known && kind_of(draft.row) != kind_of(row);
    if (!draft.refuses("kind") && !contradicts_kind) {
        check_cells(row, known, draft, declaration, report);
    }
    settle(row);
}

}  // namespace cgw::catalogue
