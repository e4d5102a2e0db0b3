// The entry sheet for paper and for cgw import table: Markdown and CSV. Every row says which device it is
// for, so that none is typed into the other one.
#include <fmt/format.h>

#include <algorithm>

#include "emit/artefacts.hpp"
#include "emit/sheet_rows.hpp"
#include "emit/text_cells.hpp"

namespace cgw::emit {
namespace {

constexpr std::array formats{
    Format{"md", "entry-sheet.md"},
    Format{"csv", "entry-sheet.csv"},
    Format{"html", "entry-sheet.html"},
};

void markdown_table(std::string& text, const DeviceSheet& sheet, bool only_set) {
    text += "| Device | Number | Parameter | Value | Unit | Default |\n|---|---:|---|---:|---|---:|\n";
    for (const SheetRow& row : sheet.rows) {
        if (row.is_set || !only_set) {
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", parameter::to_text(sheet.device),
                                row.row->number, markdown_cell(row.row->name), row.value,
                                markdown_cell(row.unit), row.default_value);
        }
    }
}

std::string render_sheet_markdown(const EntrySheet& sheet) {
    std::string text = fmt::format("# {}\n\nConfiguration `{}`, node {}\n", markdown_cell(heading_of(sheet)),
                                   sheet.configuration_id, sheet.node_id);
    text += sheet.main_cycle.empty() ? "" : fmt::format("\n{}\n", sheet.main_cycle);
    text += fmt::format("\n{}\n", defaults_remark);
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

void csv_lines(std::string& text, const EntrySheet& sheet, const DeviceSheet& device, bool is_set) {
    for (const SheetRow& row : device.rows) {
        if (row.is_set == is_set) {
            text += fmt::format("{},{},{},{},{},{},{},{},{}\n", parameter::to_text(device.device),
                                row.row->number, csv_field(row.row->name), row.value, csv_field(row.unit),
                                row.default_value == "-" ? "" : row.default_value, row.differs ? "yes" : "no",
                                sheet.configuration_id, csv_field(sheet.title));
        }
    }
}

// Each parameter once: first what the file sets, then the rest.
std::string render_sheet_csv(const EntrySheet& sheet) {
    std::string text = "device,number,parameter,value,unit,default,differs,configuration_id,title\n";
    for (const DeviceSheet& device : sheet.devices) {
        csv_lines(text, sheet, device, true);
        csv_lines(text, sheet, device, false);
    }
    return text;
}

// In the order of the formats.
constexpr std::array renderers{render_sheet_markdown, render_sheet_csv, render_sheet_html};
static_assert(formats.size() == renderers.size());

}  // namespace

std::span<const Format> entry_sheet_formats() {
    return formats;
}

base::Bytes emit_entry_sheet(const Plant& plant, const Options& options) {
    const auto* const format = std::find_if(formats.begin(), formats.end(),
                                            [&](const Format& row) { return row.name == options.format; });
    const std::size_t position =
        format != formats.end() ? static_cast<std::size_t>(format - formats.begin()) : 0;
    return base::to_bytes(renderers.at(position)(entry_sheet(plant)));
}

}  // namespace cgw::emit
