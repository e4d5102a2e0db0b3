// The entry sheet for paper and for cgw import table: Markdown and CSV. Every row says which device it is
// for, so that none is typed into the other one.
#include <fmt/format.h>

#include "base/columns.hpp"
#include "base/sheet_words.hpp"
#include "base/text_cells.hpp"
#include "emit/artefacts.hpp"
#include "emit/renderings.hpp"
#include "emit/sheet_rows.hpp"

namespace cgw::emit {
namespace {

using parameter::Device;

void markdown_table(std::string& text, const DeviceSheet& sheet, bool only_differing) {
    text += "| Device | Number | Parameter | Value | Unit | Default |\n|---|---:|---|---:|---|---:|\n";
    for (const SheetRow& row : sheet.rows) {
        if (row.differs || !only_differing) {
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", parameter::to_text(sheet.device),
                                row.row->number, base::markdown_cell(row.row->name), row.value,
                                base::markdown_cell(row.unit), row.default_value);
        }
    }
}

std::string render_sheet_markdown(const EntrySheet& sheet) {
    std::string text =
        fmt::format("# {}\n\nConfiguration `{}`, node {}\n", base::markdown_cell(heading_of(sheet)),
                    sheet.configuration_id, sheet.node_id);
    text += sheet.main_cycle.empty() ? "" : fmt::format("\n{}\n", sheet.main_cycle);
    text += fmt::format("\n{} {}\n", tables_remark, defaults_remark);
    for (const DeviceSheet& device : sheet.devices) {
        text += fmt::format("\n## {}: set these\n\n", device_heading(device.device));
        markdown_table(text, device, true);
        text += fmt::format("\n## {}: all that concern CANopen\n\n", device_heading(device.device));
        markdown_table(text, device, false);
    }
    text += fmt::format("\n{}\n\n## Then\n\n", switches_remark);
    for (const std::string_view step : closing_steps) {
        text += fmt::format("- {}\n", step);
    }
    return text;
}

struct CsvLine {
    const EntrySheet& sheet;
    Device device;
    const SheetRow& row;
};

constexpr base::Column<CsvLine> csv_columns[] = {
    {"device", [](const CsvLine& line) { return std::string(parameter::to_text(line.device)); }},
    {"number", [](const CsvLine& line) { return fmt::format("{}", line.row.row->number); }},
    {"parameter", [](const CsvLine& line) { return std::string(line.row.row->name); }},
    {"value", [](const CsvLine& line) { return line.row.value; }},
    {"unit", [](const CsvLine& line) { return line.row.unit; }},
    {"default",
     [](const CsvLine& line) { return line.row.default_value == "-" ? "" : line.row.default_value; }},
    {"differs", [](const CsvLine& line) { return std::string(line.row.differs ? "yes" : "no"); }},
    {"configuration_id", [](const CsvLine& line) { return line.sheet.configuration_id; }},
    {base::sheet_title_column, [](const CsvLine& line) { return line.sheet.title; }},
    {base::sheet_main_cycle_column,
     [](const CsvLine& line) { return fmt::format("{}", line.sheet.main_cycle_us); }},
};

// Each parameter once: first what differs from the default, then the rest.
std::string render_sheet_csv(const EntrySheet& sheet) {
    constexpr std::span<const base::Column<CsvLine>> columns = csv_columns;
    std::string text = base::csv_heading(columns);
    for (const DeviceSheet& device : sheet.devices) {
        for (const bool differs : {true, false}) {
            for (const SheetRow& row : device.rows) {
                text += row.differs == differs ? base::csv_line(columns, {sheet, device.device, row}) : "";
            }
        }
    }
    return text;
}

constexpr std::array renderings{
    Rendering<EntrySheet>{{"md", "entry-sheet.md"}, render_sheet_markdown},
    Rendering<EntrySheet>{{"csv", "entry-sheet.csv"}, render_sheet_csv},
    Rendering<EntrySheet>{{"html", "entry-sheet.html"}, render_sheet_html},
};
constexpr std::array formats = formats_of(renderings);

}  // namespace

std::span<const Format> entry_sheet_formats() {
    return formats;
}

base::Bytes emit_entry_sheet(const Plant& plant, const Options& options) {
    return base::to_bytes(find_rendering(renderings, options.format).render(entry_sheet(plant)));
}

}  // namespace cgw::emit
