#include <fmt/format.h>

#include "emit/report_parts.hpp"
#include "emit/sheet_rows.hpp"

namespace cgw::emit {

void add_entry_sheets(const Plant& plant, Blocks& blocks) {
    const EntrySheet sheet = entry_sheet(plant);
    blocks.emplace_back(page::Heading{2, "Entry sheets"});
    blocks.emplace_back(page::Paragraph{std::string(defaults_remark)});
    if (!sheet.main_cycle.empty()) {
        blocks.emplace_back(page::Paragraph{sheet.main_cycle});
    }
    for (const DeviceSheet& device : sheet.devices) {
        const std::string_view name = device_heading(device.device);
        blocks.emplace_back(page::Heading{3, std::string(name)});
        page::Table table{
            fmt::format("All parameters of the {} that concern CANopen", parameter::to_text(device.device)),
            {{"Number", true},
             {"Parameter"},
             {"Value", true},
             {"Unit"},
             {"Default", true},
             {"Done", false, true}},
            {}};
        for (const SheetRow& row : device.rows) {
            table.rows.push_back({std::to_string(row.row->number), std::string(row.row->name), row.value,
                                  row.unit, row.default_value, ""});
        }
        blocks.emplace_back(std::move(table));
    }
    blocks.emplace_back(page::Paragraph{std::string(switches_remark)});
    blocks.emplace_back(page::Heading{3, "Then"});
    blocks.emplace_back(page::Items{true, {closing_steps.begin(), closing_steps.end()}});
}

}  // namespace cgw::emit
