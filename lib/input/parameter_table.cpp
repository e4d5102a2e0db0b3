#include "input/parameter_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/tables.hpp"
#include "input/foreign_rows.hpp"
#include "input/parameter_keys.hpp"
#include "input/table_rows.hpp"
#include "input/table_values.hpp"
#include "toml/document.hpp"
#include "toml/source.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using parameter::Device;
using parameter::Row;

constexpr std::size_t names_in_a_note = 6;

Device other_device(Device device) {
    return device == Device::governor ? Device::gateway : Device::governor;
}

std::string spelling_of(const TableRow& row) {
    return row.name.text.empty() ? row.number.text : fmt::format("{} {}", row.number.text, row.name.text);
}

class TableReader {
  public:
    TableReader(const std::string& path, Device device, const parameter::Catalogue& catalogue,
                diagnostic::Findings& findings)
        : path_(path),
          device_(device),
          catalogue_(catalogue),
          findings_(findings),
          foreign_rows_(device, catalogue) {}

    PrintedTable read(const RowsRead& read) {
        read_facts(read.facts);
        if (read.rows.empty()) {
            report_empty(read.of_other_device);
        } else if (!report_other_device(read.rows)) {
            for (const TableRow& row : read.rows) {
                read_row(row);
            }
            report_measurements();
            report_foreign(read.of_other_device);
        }
        return std::move(table_);
    }

  private:
    // Whether the main cycle is one that a governor can have is said of the written file.
    void read_facts(const SheetFacts& facts) {
        table_.title = facts.title;
        if (!facts.main_cycle) {
            return;
        }
        const std::string& text = facts.main_cycle->text;
        const auto cycle = base::parse_integer(text);
        if (cycle && *cycle > 0 && *cycle <= std::numeric_limits<std::uint32_t>::max() &&
            base::consists_of(text, base::digits)) {
            table_.main_cycle_us = static_cast<std::uint32_t>(*cycle);
        } else {
            report(rules::table_row, facts.main_cycle->range,
                   fmt::format("the main cycle {} is no number of microseconds", toml::quoted(text)));
        }
    }

    void report(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                std::string help = {}) {
        findings_.report({&rule, std::move(message), {path_, where}, {}, std::move(help)});
    }

    // What was wrong with every line that looked like a row has been said already.
    void report_empty(std::size_t of_other_device) {
        if (!findings_.has_errors()) {
            const std::string_view device = parameter::to_text(device_);
            report(rules::table_empty, {},
                   of_other_device > 0
                       ? fmt::format("the table has no row of the {}, only of the other device", device)
                       : fmt::format("the table of the {} has no row", device),
                   "the columns are Number, Parameter, Value, Unit");
        }
    }

    bool fits(const TableRow& row, Device device) const {
        return resolve_silently(catalogue_, device, spelling_of(row)) != nullptr;
    }

    // A table of the wrong device is one mistake and not one in every row.
    bool report_other_device(const std::vector<TableRow>& rows) {
        const Device other = other_device(device_);
        const TableRow* first = nullptr;
        std::size_t ours = 0;
        std::size_t theirs = 0;
        for (const TableRow& row : rows) {
            const bool fits_us = fits(row, device_);
            const bool fits_them = fits(row, other);
            ours += fits_us && !fits_them ? 1 : 0;
            theirs += fits_them && !fits_us ? 1 : 0;
            first = first == nullptr && fits_them && !fits_us ? &row : first;
        }
        if (theirs <= ours) {
            return false;
        }
        report(rules::table_of_other_device, first->number.range,
               fmt::format("this looks like a table of the {}: {} rows fit only that, {} only the {}",
                           parameter::to_text(other), theirs, ours, parameter::to_text(device_)),
               fmt::format("give it as --{}", parameter::to_text(other)));
        return true;
    }

    void read_row(const TableRow& row) {
        const Row* parameter = resolve(row);
        if (parameter == nullptr) {
            return;
        }
        // What stands there can be the name, or a name and the value: 902 "Sensor 2" (D13).
        if (!row.has_columns && !row.name.text.empty() && parameter->name.empty()) {
            report(rules::table_row, row.name.range,
                   fmt::format("{} has no name known here, so {} may be its name or part of it",
                               parameter->number, toml::quoted(row.name.text)),
                   "separate the columns with tabs or semicolons, or leave out the name");
            return;
        }
        if (!parameter->settable()) {
            measurements_.push_back({parameter, row.number.range, parameter->number});
            return;
        }
        ValueReading reading = read_table_value(*parameter, row.value.text, row.unit.text);
        if (!reading.value) {
            const bool is_empty = row.value.text.empty();
            report(*reading.rule, is_empty ? row.number.range : row.value.range, std::move(reading.message),
                   std::move(reading.help));
            return;
        }
        assign(*parameter, row, *reading.value);
    }

    // Sheets and overlapping pages print a row twice; only two values are a contradiction.
    void assign(const Row& parameter, const TableRow& row, const TableValue& value) {
        const auto [place, is_new] = table_.values.try_emplace(parameter.number);
        if (is_new) {
            place->second = {
                &parameter, value.value, value.literal, {path_, row.number.range}, {path_, row.value.range}};
        } else if (place->second.value != value.value) {
            findings_.report({&rules::parameter_duplicate,
                              fmt::format("{} is {} here and {} before", parameter::label(parameter),
                                          row.value.text, place->second.literal),
                              {path_, row.value.range},
                              {{place->second.where, "first value here"}}});
        }
    }

    const Row* resolve(const TableRow& row) {
        const Row* found = resolve_silently(catalogue_, device_, spelling_of(row));
        const auto number = static_cast<std::uint16_t>(base::parse_integer(row.number.text).value_or(0));
        if (found == nullptr && foreign_rows_.contains(row, number)) {
            foreign_.push_back({nullptr, row.number.range, number});
            return nullptr;
        }
        if (found == nullptr) {
            report_unresolved(row, number);
            return nullptr;
        }
        const Row* by_name = row.name.text.empty() ? found : catalogue_.find(device_, row.name.text);
        const bool is_misprint = found->number != number || (by_name != found && !found->name.empty());
        if (is_misprint) {
            report(rules::manual_misprint, found->number != number ? row.number.range : row.name.range,
                   fmt::format("{} is a misprint of the manual, read as {}", spelling_of(row),
                               parameter::label(*found)));
        }
        return found;
    }

    void report_unresolved(const TableRow& row, std::uint16_t number) {
        const Row* by_number = catalogue_.find(device_, number);
        const Row* by_name = row.name.text.empty() ? nullptr : catalogue_.find(device_, row.name.text);
        if (by_number != nullptr || by_name != nullptr) {
            const bool is_name_wrong = by_name == nullptr;
            report(rules::parameter_name_mismatch, is_name_wrong ? row.name.range : row.number.range,
                   mismatch_message(catalogue_, device_, number, row.name.text), help_for(row, by_number));
            return;
        }
        report(rules::parameter_unknown, row.number.range,
               fmt::format("the {} has no parameter {}", parameter::to_text(device_),
                           toml::quoted(spelling_of(row))),
               help_for(row, nullptr));
    }

    std::string help_for(const TableRow& row, const Row* by_number) {
        const Device other = other_device(device_);
        if (const Row* foreign = resolve_silently(catalogue_, other, spelling_of(row))) {
            return fmt::format("{} belongs to the {}", parameter::label(*foreign), parameter::to_text(other));
        }
        if (by_number != nullptr) {
            return by_number->name.empty() ? "" : fmt::format("is it {}?", parameter::label(*by_number));
        }
        constexpr int most_suggestions = 50;  // a file of nonsense stays cheap
        constexpr std::size_t longest_name = 100;
        if (!row.name.text.empty() && row.name.text.size() < longest_name &&
            suggestions_++ < most_suggestions) {
            const std::string near = base::nearest_name(row.name.text, catalogue_.names(device_));
            if (!near.empty()) {
                return fmt::format("did you mean {}?", parameter::label(*catalogue_.find(device_, near)));
            }
        }
        return "leave out what does not concern CANopen";
    }

    void report_foreign(std::size_t of_other_device) {
        if (foreign_.empty()) {
            return;
        }
        if (table_.values.empty() && measurements_.empty()) {
            report_empty(of_other_device);
            return;
        }
        constexpr std::size_t numbers_in_a_note = 12;
        std::string numbers;
        for (std::size_t i = 0; i < foreign_.size() && i < numbers_in_a_note; ++i) {
            numbers += fmt::format("{}{}", i == 0 ? "" : ", ", foreign_[i].number);
        }
        const std::size_t count = foreign_.size();
        if (count > numbers_in_a_note) {
            numbers += fmt::format(" and {} more", count - numbers_in_a_note);
        }
        report(rules::table_row_skipped, foreign_.front().where,
               fmt::format("skipped: {} that {} not concern CANopen: {}",
                           count == 1 ? "a row" : fmt::format("{} rows", count), count == 1 ? "does" : "do",
                           numbers));
    }

    void report_measurements() {
        if (measurements_.empty()) {
            return;
        }
        std::string names;
        for (std::size_t i = 0; i < measurements_.size() && i < names_in_a_note; ++i) {
            names += (i == 0 ? "" : ", ") + parameter::label(*measurements_[i].row);
        }
        const std::size_t count = measurements_.size();
        if (count > names_in_a_note) {
            names += fmt::format(" and {} more", count - names_in_a_note);
        }
        report(rules::table_row_skipped, measurements_.front().where,
               fmt::format("{} skipped: {}", count == 1 ? "a measurement is" : "measurements are", names));
    }

    struct Skipped {
        const Row* row = nullptr;  // none: not in the catalogue
        diagnostic::Range where;
        std::uint16_t number = 0;
    };

    const std::string& path_;
    Device device_;
    const parameter::Catalogue& catalogue_;
    diagnostic::Findings& findings_;
    ForeignRows foreign_rows_;
    PrintedTable table_;
    std::vector<Skipped> measurements_;
    std::vector<Skipped> foreign_;
    int suggestions_ = 0;
};

// pdf readers write a form feed between pages.
std::string without_form_feeds(std::string_view text) {
    std::string result(text);
    std::replace(result.begin(), result.end(), '\f', ' ');
    return result;
}

bool is_html(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of("\xEF\xBB\xBF \t\r\n"), text.size());
    const std::string start = base::lowered(text.substr(first, 14));
    return start.starts_with("<!doctype html") || start.starts_with("<html") || start.starts_with("<?xml");
}

}  // namespace

PrintedTable read_parameter_table(std::string_view text, const std::string& path, Device device,
                                  const parameter::Catalogue& catalogue, diagnostic::Findings& findings) {
    const std::string readable = without_form_feeds(text);
    if (const auto complaint = toml::check_characters(toml::Source(readable))) {
        findings.report({complaint->rule, complaint->message, {path, complaint->where}, {}, complaint->help});
        return {};
    }
    if (is_html(readable)) {
        findings.report({&rules::table_empty,
                         "this is a page in HTML and not a table in text",
                         {path, {{1, 1}, {1, 1}}},
                         {},
                         "use the CSV or the Markdown of the sheet"});
        return {};
    }
    diagnostic::Findings own;
    const RowsRead rows = read_rows(readable, path, device, catalogue, own);
    PrintedTable table = TableReader(path, device, catalogue, own).read(rows);
    for (const diagnostic::Diagnostic& finding : own.all()) {
        findings.report(finding);
    }
    return table;
}

}  // namespace cgw::input
