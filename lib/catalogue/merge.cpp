#include "catalogue/merge.hpp"

#include <algorithm>
#include <charconv>
#include <deque>

#include <fmt/format.h>

#include "catalogue/kinds.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Catalogue;
using parameter::List;
using parameter::Row;
namespace rules = diagnostic::rules;

// "{5}" becomes 5 + offset, so that the text of an array's element names the element.
std::string expand_text(std::string_view text, std::uint32_t offset) {
    std::string result;
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        result += text.substr(0, open);
        if (open == std::string_view::npos) {
            break;
        }
        text.remove_prefix(open);
        const std::size_t close = text.find('}');
        std::uint32_t number = 0;
        const auto [end, error] =
            std::from_chars(text.data() + 1, text.data() + std::min(close, text.size()), number);
        if (close == std::string_view::npos || error != std::errc{} || end != text.data() + close) {
            result += text.front();
            text.remove_prefix(1);
        } else {
            result += fmt::format("{}", number + offset);
            text.remove_prefix(close + 1);
        }
    }
    return result;
}

// One row of a draft, with the texts it owns.
struct Expanded {
    Row row;
    std::string name;
    std::string text;
    std::deque<std::string> alias_texts;
    std::vector<std::string_view> aliases;
};

void expand(const Draft& draft, std::uint16_t offset, Expanded& one) {
    one.row = draft.row;
    one.row.number = static_cast<std::uint16_t>(draft.row.number + offset);
    if (draft.count == 0 && draft.last == 0) {
        return;
    }
    one.text = expand_text(draft.row.text, offset);
    one.row.text = one.text;
    if (draft.count == 0) {
        return;
    }
    one.name = fmt::format("{}({})", draft.row.name, offset);
    one.row.name = one.name;
    for (const std::string_view alias : draft.aliases) {
        one.aliases.push_back(one.alias_texts.emplace_back(fmt::format("{}({})", alias, offset)));
    }
    one.row.aliases = one.aliases;
    one.row.array_first = draft.row.number;
    one.row.array_size = draft.count;
    if (offset != 0 || one.row.list_end == 0) {
        one.row.list_end = static_cast<std::uint16_t>(draft.row.number + draft.count - 1);
    }
}

bool contradicts(const Row& known, const Row& said, std::string_view cell, const std::string& old_value,
                 const std::string& new_value, const Draft& draft, const Reporter& report) {
    if (old_value == new_value) {
        return false;
    }
    report(rules::declaration_contradiction, draft.where(cell),
           fmt::format("`{}` has {} {} already, not {}", label(known.name.empty() ? said : known), cell,
                       old_value, new_value));
    return true;
}

// The known row with its blanks filled; what contradicts it is reported and not taken over.
Row fill(const Row& known, const Row& said, const Draft& draft, const Reporter& report) {
    Row merged = known;
    if (draft.kind_known && contradicts(known, said, "kind", fmt::format("\"{}\"", kind_of(known)),
                                        fmt::format("\"{}\"", kind_of(said)), draft, report)) {
        return merged;
    }
    for (const Cell& cell : all_cells()) {
        const bool refused = cell.name == "width" && cell.blank(said);  // a finding already
        if (cell.shown == nullptr || !draft.says(cell.name) || refused) {
            continue;
        }
        if (cell.blank(known)) {
            cell.copy(said, merged);
        } else {
            contradicts(known, said, cell.name, cell.shown(known), cell.shown(said), draft, report);
        }
    }
    return merged;
}

bool name_is_free(const Row& row, std::string_view name, const Draft& draft, std::string_view cell,
                  const Catalogue& catalogue, const Reporter& report) {
    const Row* other = name.empty() ? nullptr : catalogue.find(row.device, name);
    if (other == nullptr || other->number == row.number) {
        return true;
    }
    report(rules::declaration_invalid, draft.where(cell),
           fmt::format("the name {} belongs to {} already", name, other->number));
    return false;
}

bool names_are_free(const Row& row, const Draft& draft, const Catalogue& catalogue, const Reporter& report) {
    bool free = name_is_free(row, row.name, draft, "name", catalogue, report);
    if (row.array_first == row.number) {
        free = name_is_free(row, array_name(row), draft, "name", catalogue, report) && free;
    }
    for (const std::string_view alias : row.aliases) {
        free = name_is_free(row, alias, draft, "aliases", catalogue, report) && free;
    }
    return free;
}

void require(std::string_view cell, const Row& row, const Draft& draft, const Reporter& report) {
    report(rules::key_missing, draft.table.range, fmt::format("`{}` of {} is missing", cell, row.number));
}

bool fits(const parameter::Scaling& scaling, unsigned width, bool is_signed) {
    const std::int32_t steps = std::int32_t{1} << width;
    const std::int32_t lowest = is_signed ? -steps / 2 : 0;
    return scaling.internal_minimum >= lowest && scaling.internal_maximum < lowest + steps;
}

// D13: what a TPDO carries is known with its width and sign. The gateway's own measurements are never sent.
void check_width(Row& row, const Row* known, const Draft& draft, const Reporter& report) {
    const bool sent = row.device == parameter::Device::governor;
    const bool was_known = known != nullptr && known->width != 0;
    if (row.width == 0 && !draft.says("width") && (sent || draft.says("signed"))) {
        require("width", row, draft, report);
    } else if (row.width > 1 && !was_known && !draft.says("signed")) {
        require("signed", row, draft, report);
    }
    if (sent && row.width == 0) {
        constexpr std::uint8_t after_a_finding = 16;  // so that its use in a TPDO is not another one
        row.width = after_a_finding;
    }
}

void check_scaling(Row& row, const Draft& draft, const Reporter& report) {
    if (!row.scaling) {
        return;
    }
    const parameter::Scaling& scaling = *row.scaling;
    if (scaling.internal_minimum == scaling.internal_maximum) {
        if (!draft.says("internal")) {
            require("internal", row, draft, report);
        }
        row.scaling.reset();
    } else if (row.is_bit()) {
        report(rules::declaration_invalid, draft.where("internal"), "a bit has no internal range");
        row.scaling.reset();
    } else if (row.width != 0 && !fits(scaling, row.width, row.is_signed)) {
        report(rules::declaration_invalid, draft.where("internal"),
               fmt::format("internal [{}, {}] does not fit {} bits, {}", scaling.internal_minimum,
                           scaling.internal_maximum, row.width, row.is_signed ? "signed" : "unsigned"));
        row.scaling.reset();
    }
}

void check_settable(const Row& row, const Draft& draft, bool declaration, const Reporter& report) {
    for (const Cell& cell : all_cells()) {
        if (cell.of_measurement && draft.says(cell.name)) {
            report(rules::declaration_invalid, draft.where(cell.name),
                   fmt::format("`{}` describes measurements, and {} is a {}", cell.name, row.number,
                               kind_of(row)));
        }
    }
    if (declaration && row.name.empty()) {
        require("name", row, draft, report);
    }
}

void check_choices(const Row& row, const Draft& draft, const Reporter& report) {
    for (const std::uint32_t choice : row.choices) {
        if (choice < row.minimum.value_or(choice) || choice > row.maximum.value_or(choice)) {
            report(rules::declaration_invalid, draft.where("choices"),
                   fmt::format("choice {} is outside the range of {}", choice, row.number));
        }
    }
}

void check_row(Row& row, const Row* known, const Draft& draft, bool declaration, const Reporter& report) {
    if (known == nullptr && !draft.kind_known) {
        if (!draft.says("kind")) {
            require("kind", row, draft, report);
        }
        row.list = List::measurement;  // the likeliest, so that this is the only finding
        return;
    }
    if (draft.kind_known && kind_of(draft.row) != kind_of(row)) {
        return;  // a contradiction, reported
    }
    if (row.list == List::measurement) {
        if (row.name.empty()) {
            require("name", row, draft, report);
        }
        check_width(row, known, draft, report);
        check_scaling(row, draft, report);
    } else {
        check_settable(row, draft, declaration, report);
    }
    check_choices(row, draft, report);
}

// What shapes the expansion; reported once for all its rows.
void check_shape(const Draft& draft, const Reporter& report) {
    if (draft.count != 0 && (draft.last != 0 || draft.row.name.empty())) {
        report(rules::declaration_invalid, draft.where("count"), "an array has a `name` and no `last`");
    }
    if (draft.last != 0 && (draft.says("name") || draft.says("aliases"))) {
        report(rules::declaration_invalid, draft.where("last"),
               "rows number..last have no name; an array has `count`");
    }
    if ((draft.count != 0 || draft.last != 0) && draft.says("misprints")) {
        report(rules::declaration_invalid, draft.where("misprints"), "misprints belong to single rows");
    }
    const int end = draft.row.number + draft.count - 1;
    if (draft.says("list_end") && (draft.count == 0 || draft.row.list_end < end)) {
        report(rules::declaration_invalid, draft.where("list_end"),
               "list_end belongs to an array and is not before its end");
    }
}

}  // namespace

const Row* merge(const Draft& draft, bool declaration, Catalogue& catalogue, const Reporter& report) {
    const std::size_t findings_before = report.findings().all().size();
    check_shape(draft, report);
    if (report.findings().all().size() != findings_before) {
        return nullptr;
    }
    const Row* first = nullptr;
    const int rows = draft.count != 0 ? draft.count : draft.last != 0 ? draft.last - draft.row.number + 1 : 1;
    for (int offset = 0; offset < rows; ++offset) {
        Expanded one;
        expand(draft, static_cast<std::uint16_t>(offset), one);
        const Row* known = catalogue.find(one.row.device, one.row.number);
        Row row = known != nullptr ? fill(*known, one.row, draft, report) : one.row;
        check_row(row, known, draft, declaration, report);
        if (!names_are_free(row, draft, catalogue, report)) {
            return nullptr;
        }
        const Row* added = catalogue.put(row);
        first = offset == 0 ? added : first;
    }
    return first;
}

void check_references(const toml::Node& table, parameter::Device device, const Catalogue& catalogue,
                      const Reporter& report) {
    const toml::Entry* external = table.find("external");
    if (external == nullptr) {
        return;
    }
    for (const toml::Node& element : external->value.elements) {
        const toml::Entry* entry = element.find("parameter");
        if (entry == nullptr || entry->value.integer < 1 || entry->value.integer > highest_number) {
            continue;
        }
        const Row* row = catalogue.find(device, static_cast<std::uint16_t>(entry->value.integer));
        if (row == nullptr || !row->settable()) {
            report(rules::declaration_invalid, entry->value.range,
                   fmt::format("{} is no settable parameter of the {}", entry->value.text, to_text(device)));
        }
    }
}

}  // namespace cgw::catalogue
