// The entry sheet as one HTML page for A4 paper: no script, nothing loaded from elsewhere; also well-formed
// XML.
#include <fmt/format.h>

#include "base/text_cells.hpp"
#include "emit/pdo_rows.hpp"
#include "emit/sheet_rows.hpp"

namespace cgw::emit {
namespace {

using base::html_text;

constexpr std::string_view style =
    "@page { size: A4; margin: 15mm }\n"
    "body { font: 10pt sans-serif; max-width: 180mm; margin: auto; color: #000 }\n"
    "h1 { font-size: 15pt } h2 { font-size: 12pt; break-after: avoid }\n"
    "table { border-collapse: collapse; width: 100% }\n"
    "thead { display: table-header-group } tr { break-inside: avoid }\n"
    "th, td { border: 1px solid #888; padding: 1mm 2mm; text-align: left }\n"
    ".n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap }\n"
    ".done { width: 12mm }\n"
    ".zero { color: #666 }\n"
    "@media screen { body { padding: 4mm } }\n"
    "@media (max-width: 140mm) { body { font-size: 8pt } th, td { padding: 1mm } .done { width: auto }\n"
    "  .name { overflow-wrap: anywhere } }\n";

std::string table_row(const SheetRow& row) {
    return fmt::format(
        "<tr{}><td class=\"n\">{}</td><td class=\"name\">{}</td><td class=\"n\">{}</td><td>{}</td>"
        "<td class=\"n\">{}</td><td class=\"done\"></td></tr>\n",
        row.differs ? "" : " class=\"zero\"", row.row->number, html_text(row.row->name), row.value,
        html_text(row.unit), row.default_value);
}

// `done` heads the column that is ticked by hand.
std::string table(const DeviceSheet& sheet, bool only_differing, std::string_view done) {
    std::string text = fmt::format(
        "<table>\n<thead><tr><th class=\"n\">Number</th><th>Parameter</th><th class=\"n\">Value</th>"
        "<th>Unit</th><th class=\"n\">Default</th><th class=\"done\">{}</th></tr></thead>\n<tbody>\n",
        done);
    for (const SheetRow& row : sheet.rows) {
        text += row.differs || !only_differing ? table_row(row) : "";
    }
    return text + "</tbody>\n</table>\n";
}

}  // namespace

std::string render_sheet_html(const EntrySheet& sheet) {
    const std::string heading = html_text(heading_of(sheet));
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>{}</title>\n"
        "<style>\n{}</style>\n</head>\n<body>\n<h1>{}</h1>\n<p>Configuration <code>{}</code>, node {}</p>\n",
        heading, style, heading, sheet.configuration_id, sheet.node_id);
    text += sheet.main_cycle.empty() ? "" : fmt::format("<p>{}</p>\n", html_text(sheet.main_cycle));
    text += fmt::format("<p>{} {}</p>\n", html_text(tables_remark), html_text(defaults_remark));
    for (const DeviceSheet& device : sheet.devices) {
        const std::string_view name = device_heading(device.device);
        text += fmt::format("<h2>{}: set these</h2>\n{}", name, table(device, true, "Typed"));
        text += fmt::format("<h2>{}: all that concern CANopen</h2>\n{}", name, table(device, false, "Read"));
    }
    text += fmt::format("<p>{}</p>\n<h2>Then</h2>\n<ol>\n", html_text(switches_remark));
    for (const std::string_view step : closing_steps) {
        text += fmt::format("<li>{}</li>\n", html_text(step));
    }
    return text + "</ol>\n</body>\n</html>\n";
}

}  // namespace cgw::emit
