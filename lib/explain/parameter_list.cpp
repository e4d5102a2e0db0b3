#include <vector>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "explain/lists.hpp"
#include "explain/text.hpp"
#include "explain/wording.hpp"

namespace cgw::explain {

namespace {

using parameter::Catalogue;
using parameter::Device;
using parameter::Program;
using parameter::Row;

// Rows that share a line: all elements of an array, or numbers without a name that follow each other.
struct Run {
    const Row* first = nullptr;
    const Row* last = nullptr;
};

bool same_facts(const Row& a, const Row& b) {
    return a.list == b.list && a.role == b.role && a.level == b.level && range_text(a) == range_text(b) &&
           a.section == b.section;
}

bool continues(const Run& run, const Row& row) {
    const bool same_array = run.first->array_first != 0 && run.first->array_first == row.array_first;
    const bool nameless = run.first->name.empty() && row.name.empty();
    return (same_array || nameless) && run.last->number + 1 == row.number && same_facts(*run.first, row) &&
           merged_text(run.first->text, row.text) && merged_text(run.first->used, row.used);
}

std::vector<Run> runs_of(const std::vector<const Row*>& rows, bool merged) {
    std::vector<Run> runs;
    for (const Row* row : rows) {
        if (merged && !runs.empty() && continues(runs.back(), *row)) {
            runs.back().last = row;
        } else {
            runs.push_back({row, row});
        }
    }
    return runs;
}

std::string both(std::string_view first, std::string_view last) {
    return merged_text(first, last).value_or(std::string(first));
}

// The range in the width of a column: without the values between, where only some are taken.
std::string limits_text(Row row) {
    row.choices = {};
    return range_text(row);
}

std::string number_or_nothing(std::optional<double> value) {
    return value ? base::to_text(*value) : "";
}

std::vector<std::string> cells(const Run& run) {
    const Row& first = *run.first;
    const Row& last = *run.last;
    return {
        program_text(first.device, first.program),
        std::string(to_text(first.device)),
        std::string(to_text(first.program)),
        both(fmt::format("{}", first.number), fmt::format("{}", last.number)),
        both(first.name, last.name),
        limits_text(first),
        range_text(first),
        std::string(to_text(first.list)),
        first.level == 0 ? "" : fmt::format("{}", first.level),
        number_or_nothing(first.minimum),
        number_or_nothing(first.maximum),
        std::string(first.unit),
        first.base == parameter::Base::hexadecimal ? "hexadecimal" : "decimal",
        both(first.text, last.text),
        both(first.used, last.used),
        std::string(first.section),
        fmt::format("{}", fmt::join(first.pages, ", ")),
    };
}

}  // namespace

Table parameter_list(const Catalogue& catalogue, std::optional<Device> device, bool for_people) {
    Table table{"parameters", true, {}, {}};
    table.columns = {
        {"", "", 0},
        {"device", "", in_data},
        {"program", "", in_data},
        {"number", "number", everywhere, true},
        {"name", "name"},
        {"", "range", in_text},
        {"range", "range", in_page},
        {"list", "list"},
        {"level", "level", everywhere, true},
        {"minimum", "", in_data, true},
        {"maximum", "", in_data, true},
        {"unit", "", in_data},
        {"base", "", in_data},
        {"text", "meaning"},
        {"used", "feeds", in_page | in_data},
        {"source", "source", in_page | in_data},
        {"pages", "pages", in_page | in_data},
    };
    for (const Device one : {Device::governor, Device::gateway}) {
        for (const Program program : {Program::application, Program::bootloader}) {
            if (device && *device != one) {
                continue;
            }
            for (const Run& run : runs_of(catalogue.rows(one, program), for_people)) {
                table.rows.push_back(cells(run));
            }
        }
    }
    return table;
}

}  // namespace cgw::explain
