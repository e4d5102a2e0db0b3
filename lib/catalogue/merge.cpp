#include "catalogue/merge.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "catalogue/kinds.hpp"
#include "catalogue/row_checks.hpp"
#include "catalogue/templates.hpp"
#include "catalogue/values.hpp"
#include "diagnostic/rules/keys.hpp"
#include "facts/gateway.hpp"

namespace cgw::catalogue {

namespace {

using parameter::Catalogue;
using parameter::Row;
namespace rules = diagnostic::rules;

// One row of a draft, with the texts it owns.
struct Expanded {
    Row row;
    std::string name;
    std::string text;
    std::string used;
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
    one.used = expand_text(draft.row.used, offset);
    one.row.used = one.used;
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
        if (cell.shown == nullptr || !draft.says(cell.name) || draft.refuses(cell.name)) {
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
    const Row* other = name.empty() ? nullptr : catalogue.find(row.device, row.program, name);
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

// What shapes the expansion; reported once for all its rows.
void check_shape(const Draft& draft, const Reporter& report) {
    if (draft.count != 0 && (draft.last != 0 || !draft.says("name"))) {
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
    const bool end_is_known = !draft.refuses("count") && !draft.refuses("list_end");
    if (draft.says("list_end") && end_is_known && (draft.count == 0 || draft.row.list_end < end)) {
        report(rules::declaration_invalid, draft.where("list_end"),
               "list_end belongs to an array and is not before its end");
    }
}

// A switch and its type stand a fixed distance apart: a refused declaration of one leaves the other one's
// number usable.
void put_partner(const Row& row, const Draft& draft, Catalogue& catalogue) {
    constexpr std::uint16_t distance = facts::assignment_to_type;
    Row partner;
    partner.device = row.device;
    partner.program = row.program;
    partner.number =
        static_cast<std::uint16_t>(row.number < distance ? row.number + distance : row.number - distance);
    if (catalogue.find(partner.device, partner.program, partner.number) == nullptr && partner.number != 0) {
        stand_in(partner, draft);
        catalogue.put(partner);
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
        const Row* known = catalogue.find(one.row.device, one.row.program, one.row.number);
        Row row = known != nullptr ? fill(*known, one.row, draft, report) : one.row;
        check_row(row, known, draft, declaration, report);
        if (!names_are_free(row, draft, catalogue, report)) {
            if (draft.count != 0) {
                return nullptr;
            }
            const Row before = known != nullptr ? *known : Row{};
            row.name = before.name;  // the number stays usable
            row.aliases = before.aliases;
        }
        const Row* added = catalogue.put(row);
        if (known == nullptr && names_a_pair(draft)) {
            put_partner(row, draft, catalogue);
        }
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
    diagnostic::Findings reported_before;
    const std::optional<Limits> limits = read_limits(external->value, Reporter({}, reported_before));
    if (!limits) {
        return;
    }
    const std::uint16_t references[] = {limits->low.reference, limits->high.reference};
    for (std::size_t i = 0; i < std::size(references); ++i) {
        const Row* row = catalogue.find(device, references[i]);
        if (references[i] != 0 && (row == nullptr || !row->settable())) {
            report(rules::declaration_invalid, external->value.elements[i].find("parameter")->value.range,
                   fmt::format("{} is no settable parameter of the {}", references[i], to_text(device)));
        }
    }
}

}  // namespace cgw::catalogue
