#include "driver/tables.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "authoring/parameter_file_text.hpp"
#include "base/files.hpp"
#include "base/utf8.hpp"
#include "toml/document.hpp"

namespace cgw::driver {
namespace {

using parameter::Device;

void read_table(ReadTables& tables, const std::string& path, Device device,
                const parameter::Catalogue& catalogue) {
    diagnostic::Findings findings;
    base::Result<std::string> text = base::read_file(path, toml::maximum_file_size);
    if (text) {
        (device == Device::governor ? tables.governor : tables.gateway) =
            input::read_parameter_table(*text, path, device, catalogue, findings);
        tables.sources[path] = std::move(*text);
    } else {
        const bool too_large = text.error().too_large;
        tables.unreadable = tables.unreadable || !too_large;
        findings.report({too_large ? &diagnostic::rules::file_too_large : &diagnostic::rules::file_unreadable,
                         text.error().message,
                         {path, {}}});
    }
    findings.sort();
    tables.has_errors = tables.has_errors || findings.has_errors();
    if (!findings.all().empty()) {
        tables.reports.push_back({path, findings.all()});
    }
}

std::vector<authoring::WrittenValue> written(const input::PrintedTable& table) {
    std::vector<authoring::WrittenValue> values;
    for (const auto& [number, value] : table.values) {
        values.push_back({value.row, value.literal});
    }
    return values;
}

std::string file_name(const std::string& path) {
    return path == "-" ? "standard input" : base::printable(std::filesystem::path(path).filename().string());
}

}  // namespace

ReadTables read_tables(const TablePaths& paths, const parameter::Catalogue& catalogue) {
    ReadTables tables;
    read_table(tables, paths.governor, Device::governor, catalogue);
    read_table(tables, paths.gateway, Device::gateway, catalogue);
    return tables;
}

std::string text_of_tables(const ReadTables& tables, const TablePaths& paths, const std::string& title,
                           const parameter::Catalogue& catalogue) {
    authoring::Draft draft;
    draft.title = title;
    draft.remarks = {fmt::format("Governor: {}; gateway: {}. Read by cgw import table.",
                                 file_name(paths.governor), file_name(paths.gateway))};
    draft.governor = written(tables.governor);
    draft.gateway = written(tables.gateway);
    return authoring::parameter_file_text(draft, catalogue);
}

}  // namespace cgw::driver
