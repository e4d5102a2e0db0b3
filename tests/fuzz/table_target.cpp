// Any text is read for a printed table; two tables without errors give a parameter file that says what they
// say.
#include "catalogue/catalogue.hpp"
#include "driver/tables.hpp"
#include "fuzz/fuzz.hpp"

namespace cgw::fuzz {
namespace {

using parameter::Device;

void read(driver::ReadTables& tables, const std::string& path, const std::string& text, Device device,
          const parameter::Catalogue& catalogue) {
    diagnostic::Findings findings;
    (device == Device::governor ? tables.governor : tables.gateway) =
        input::read_parameter_table(text, path, device, catalogue, findings);
    tables.sources[path] = text;
    findings.sort();
    tables.has_errors = tables.has_errors || findings.has_errors();
    if (!findings.all().empty()) {
        tables.reports.push_back({path, findings.all()});
        demand_sound(tables.reports.back(), tables.sources);
    }
}

void demand_same(const input::PrintedTable& table, const parameter::ParameterSet& set) {
    for (const auto& [number, value] : table.values) {
        demand(set.value(number) == value.value, "the file has a value of the table");
    }
    for (const auto& [number, assignment] : set.all()) {
        demand(table.values.contains(number), "the file has no other values");
    }
}

}  // namespace

void table(Input input) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    const Parts parts = split(input, "#### gateway");
    const driver::TablePaths paths{"governor.csv", parts.separated ? "gateway.csv" : "governor.csv"};
    driver::ReadTables tables;
    read(tables, paths.governor, parts.first, Device::governor, catalogue);
    read(tables, paths.gateway, parts.separated ? parts.second : parts.first, Device::gateway, catalogue);
    if (!tables.valid()) {
        return;
    }
    driver::note_absent_rows(tables, paths, catalogue);
    for (const diagnostic::FileReport& report : tables.reports) {
        demand_sound(report, tables.sources);
    }
    const driver::CheckedFile file =
        driver::check_text("made.toml", driver::text_of_tables(tables, paths, "", catalogue));
    demand_sound({file.path, file.findings.all(), file.not_verified}, file.sources);
    demand_same(tables.governor, file.settings.governor);
    demand_same(tables.gateway, file.settings.gateway);
    const std::string& title = tables.governor.title.empty() ? tables.gateway.title : tables.governor.title;
    demand(file.settings.title == title, "the file has the title of the tables");
}

}  // namespace cgw::fuzz
