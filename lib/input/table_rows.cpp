#include "input/table_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "base/sheet_words.hpp"
#include "base/text_cells.hpp"
#include "diagnostic/rules/tables.hpp"
#include "input/parameter_keys.hpp"
#include "input/table_header.hpp"
#include "input/table_values.hpp"
#include "toml/document.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using parameter::Device;

bool has_dots(std::string_view text) {
    return text.find("..") != std::string_view::npos || text.find("\xE2\x80\xA6") != std::string_view::npos ||
           text == ":" || text == "\xE2\x8B\xAE";
}

bool only_dots(std::string_view text) {
    while (!text.empty()) {
        const std::size_t ascii = std::min(text.find_first_not_of(".:"), text.size());
        text.remove_prefix(ascii);
        if (text.starts_with("\xE2\x80\xA6") || text.starts_with("\xE2\x8B\xAE")) {
            text.remove_prefix(3);
        } else if (ascii == 0) {
            return false;
        }
    }
    return true;
}

// ":", "...", "…" in every cell that is not empty.
bool is_ellipsis(const CellLine& line) {
    bool any = false;
    for (const Cell& cell : line.cells) {
        if (!only_dots(cell.text)) {
            return false;
        }
        any = any || !cell.text.empty();
    }
    return any;
}

// "|---|---:|", "--- --- ---", "====="
bool is_rule(const CellLine& line) {
    bool has_dash = false;
    for (const Cell& cell : line.cells) {
        if (!cell.text.empty() && !base::consists_of(cell.text, "-:=+_")) {
            return false;
        }
        has_dash = has_dash || cell.text.find_first_of("-=_") != std::string::npos;
    }
    return has_dash;
}

// "7.1.1", "2.", "3)": sections and steps are numbered so, parameters are not.
bool is_section_number(std::string_view text) {
    int parts = text.ends_with('.') || text.ends_with(')') ? 1 : 0;
    text.remove_suffix(static_cast<std::size_t>(parts));
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('.', at), text.size());
        const std::string_view part = text.substr(at, end - at);
        if (part.size() > 2 || !base::consists_of(part, base::digits)) {
            return false;
        }
        ++parts;
        at = end + 1;
    }
    return parts > 1;
}

class RowReader {
  public:
    RowReader(const std::string& path, Device device, const parameter::Catalogue& catalogue,
              diagnostic::Findings& findings)
        : path_(path), device_(device), catalogue_(catalogue), findings_(findings) {}

    void read(std::string_view line, std::uint32_t number, std::size_t skipped) {
        CellLine cells = split_cells(line, number, separation_, skipped);
        if (cells.cells.empty() || take_fact(line, cells) || is_comment(cells) || is_rule(cells) ||
            take_header(cells, line, skipped)) {
            return;
        }
        if (is_ellipsis(cells)) {
            report_ellipsis(cells.range);
            return;
        }
        if (is_skipping_) {
            return;
        }
        read_row(cells);
    }

    RowsRead take() { return std::move(result_); }

  private:
    static bool is_comment(const CellLine& line) {
        const std::string_view first = line.cells.front().text;
        return first.starts_with('#') || first.starts_with("//");
    }

    // "# Entry sheet: Genset 2", "Main cycle of the governor: 10000 us. ..."
    bool take_fact(std::string_view line, const CellLine& cells) {
        constexpr std::string_view mark = "# ";
        std::string_view heading = line;
        heading.remove_prefix(heading.starts_with(mark) ? mark.size() : 0);
        if (heading.size() < line.size() && heading.starts_with(base::sheet_heading)) {
            heading.remove_prefix(base::sheet_heading.size());
            heading.remove_suffix(heading.ends_with('\r') ? 1 : 0);
            result_.facts.title = base::markdown_text(heading);
            return true;
        }
        if (line.starts_with(base::sheet_main_cycle)) {
            line.remove_prefix(base::sheet_main_cycle.size());
            result_.facts.main_cycle = Cell{std::string(line.substr(0, line.find(' '))), cells.range};
            return true;
        }
        return false;
    }

    // Every row of a sheet in CSV says them.
    void take_facts_of_row(const CellLine& line) {
        if (title_ && *title_ < line.cells.size()) {
            result_.facts.title = line.cells[*title_].whole;
        }
        if (main_cycle_ && *main_cycle_ < line.cells.size() && !line.cells[*main_cycle_].text.empty()) {
            result_.facts.main_cycle = line.cells[*main_cycle_];
        }
    }

    void report(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                std::string help = {}) {
        findings_.report({&rule, std::move(message), {path_, where}, {}, std::move(help)});
    }

    // Commas may separate the columns of a header although they do not in what stands above it.
    bool take_header(const CellLine& line, std::string_view text, std::size_t skipped) {
        const bool may_have_commas =
            line.separation != Separation::commas && text.find(',') != std::string_view::npos;
        const CellLine with_commas =
            may_have_commas ? split_cells(text, line.number, Separation::commas, skipped) : CellLine{};
        const std::optional<Header> by_commas =
            with_commas.separation == Separation::commas ? header_of(with_commas) : std::nullopt;
        const std::optional<Header> header = by_commas ? by_commas : header_of(line);
        if (!header) {
            return false;
        }
        const CellLine& cells = by_commas ? with_commas : line;
        separation_ = cells.separation;
        header_size_ = cells.cells.size();
        columns_ = header->columns;
        title_ = header->title;
        main_cycle_ = header->main_cycle;
        is_skipping_ = report_header(*header, cells);
        return true;
    }

    // True when the rows below cannot be read.
    bool report_header(const Header& header, const CellLine& line) {
        const bool is_usual =
            header.columns == usual_columns || header.columns == Columns{std::nullopt, 0, 1, 2, std::nullopt};
        if (!header.has(Column::value)) {
            report(rules::table_row, line.range, "the header names no column Value, so no row has one");
        } else if (!header.doubt.empty()) {
            report(rules::table_value_ambiguous, line.range, header.doubt,
                   "leave the columns Number, Parameter, Value, Unit and delete the others");
        } else if (line.separation == Separation::blanks && !is_usual) {
            report(rules::table_row, line.range,
                   "columns in another order than Number, Parameter, Value, Unit need a separator",
                   "separate them with tabs or semicolons");
        } else {
            return false;
        }
        return true;
    }

    void report_ellipsis(const diagnostic::Range& where) {
        const std::string after =
            result_.rows.empty() ? "" : fmt::format(" after {}", result_.rows.back().number.text);
        report(rules::table_ellipsis, where, fmt::format("dots stand for rows that are left out{}", after),
               "write the rows out, or delete this line if all of them are 0");
    }

    Cell cell(const CellLine& line, Column column) const {
        const std::optional<std::size_t> place = columns_[static_cast<std::size_t>(column)];
        return place && *place < line.cells.size() ? line.cells[*place] : Cell{"", line.range};
    }

    // Blanks separate: a row without a name, or without a unit, has its cells further left.
    static TableRow row_of_words(const CellLine& line) {
        const auto at = [&line](std::size_t i) {
            return i < line.cells.size() ? line.cells[i] : Cell{"", line.range};
        };
        const std::size_t value = looks_like_number(at(1).text) ? 1 : 2;
        return {at(0), value == 1 ? Cell{"", line.range} : at(1), at(value), at(value + 1), false};
    }

    // Which of two numbers is the value, blanks do not say: "902 2 Sensor 5". Further columns need a header.
    const Cell* further_number(const CellLine& line) const {
        constexpr std::size_t most_cells = 4;
        const std::size_t behind_unit =
            line.cells.size() > 1 && looks_like_number(line.cells[1].text) ? 3 : 4;
        for (std::size_t i = behind_unit; header_size_ <= most_cells && i < line.cells.size(); ++i) {
            if (looks_like_number(line.cells[i].text)) {
                return &line.cells[i];
            }
        }
        return nullptr;
    }

    void read_row(const CellLine& line) {
        const bool in_words = line.separation == Separation::blanks;
        TableRow row = in_words ? row_of_words(line)
                                : TableRow{cell(line, Column::number), cell(line, Column::name),
                                           cell(line, Column::value), cell(line, Column::unit), true};
        const std::string& number = row.number.text;
        if (number.empty() || number.front() < '0' || number.front() > '9' || is_section_number(number)) {
            report_near_row(line, row);
        } else if (has_dots(number) || has_dots(row.value.text)) {
            report_ellipsis(line.range);
        } else if (line.separation == Separation::commas && line.cells.size() > header_size_) {
            report(rules::table_value_ambiguous, line.range,
                   fmt::format("the row has {} cells below a header of {}: is one a decimal comma?",
                               line.cells.size(), header_size_),
                   "write decimals with a point, or separate the columns with semicolons");
        } else if (const Cell* further = in_words ? further_number(line) : nullptr) {
            report(rules::table_value_ambiguous, further->range,
                   fmt::format("the row has another number, {}, behind its value", further->text),
                   "separate the columns with tabs or semicolons, or give each column a name in a header");
        } else if (is_number(row.number) && is_of_this_device(line)) {
            result_.rows.push_back(std::move(row));
            take_facts_of_row(line);
        }
    }

    bool is_number(const Cell& cell) {
        const auto number = base::parse_integer(cell.text);
        if (number && !cell.text.starts_with('0') && *number <= 65535 &&
            base::consists_of(cell.text, base::digits)) {
            return true;
        }
        if (number && cell.text.starts_with('0')) {
            report(rules::table_row, cell.range,
                   fmt::format("{} begins with 0, which no parameter number does", toml::quoted(cell.text)),
                   *number > 0 ? fmt::format("write {}", *number) : "");
            return false;
        }
        const bool has_name = cell.text.find(' ') != std::string::npos;
        report(rules::table_row, cell.range,
               fmt::format("{} is no parameter number", toml::quoted(cell.text)),
               has_name ? "give number and name a column each" : "begin a line that is no row with #");
        return false;
    }

    // False also for a device that nobody knows, after a finding.
    bool is_of_this_device(const CellLine& line) {
        if (!columns_[static_cast<std::size_t>(Column::device)] || line.separation == Separation::blanks) {
            return true;
        }
        const Cell device = cell(line, Column::device);
        for (const Device known : {Device::governor, Device::gateway}) {
            if (base::equal_ignoring_case(device.text, parameter::to_text(known))) {
                result_.of_other_device += known == device_ ? 0 : 1;
                return known == device_;
            }
        }
        report(rules::table_row, device.range,
               fmt::format("device {} is neither governor nor gateway", toml::quoted(device.text)));
        return false;
    }

    bool is_parameter(const std::string& text) const {
        return !text.empty() && (resolve_silently(catalogue_, Device::governor, text) != nullptr ||
                                 resolve_silently(catalogue_, Device::gateway, text) != nullptr);
    }

    // Text between the rows is no concern of ours, unless it may be a row with something before it, or one
    // that lost its number: a parameter, and a number behind it.
    void report_near_row(const CellLine& line, const TableRow& row) {
        const auto parameter = std::find_if(line.cells.begin(), line.cells.end(),
                                            [this](const Cell& cell) { return is_parameter(cell.text); });
        const bool has_parameter = parameter != line.cells.end() &&
                                   std::any_of(parameter + 1, line.cells.end(),
                                               [](const Cell& cell) { return looks_like_number(cell.text); });
        const bool has_columns = line.separation != Separation::blanks && looks_like_number(row.value.text);
        if (has_parameter || has_columns) {
            const Cell& first = line.cells.front();
            const Cell& found = row.number.text.empty() ? first : row.number;
            const std::string shown = found.text.empty() ? "no number" : toml::quoted(found.text);
            report(rules::table_row, found.text.empty() ? line.range : found.range,
                   fmt::format("a row has {} where its parameter's number belongs", shown),
                   "delete what stands before the number, or begin a line that is no row with #");
        }
    }

    const std::string& path_;
    Device device_;
    const parameter::Catalogue& catalogue_;
    diagnostic::Findings& findings_;
    RowsRead result_;
    Columns columns_ = usual_columns;
    std::optional<std::size_t> title_;
    std::optional<std::size_t> main_cycle_;
    std::size_t header_size_ = 0;
    std::optional<Separation> separation_;  // of the header in force
    bool is_skipping_ = false;              // below a header that cannot be used
};

}  // namespace

RowsRead read_rows(std::string_view text, const std::string& path, Device device,
                   const parameter::Catalogue& catalogue, diagnostic::Findings& findings) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    RowReader reader(path, device, catalogue, findings);
    std::size_t skipped = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    std::uint32_t number = 0;
    for (std::size_t at = skipped; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        reader.read(text.substr(at, end - at), ++number, skipped);
        skipped = 0;
        at = end + 1;
    }
    return reader.take();
}

}  // namespace cgw::input
