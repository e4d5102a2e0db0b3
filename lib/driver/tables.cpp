#include "driver/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

#include "authoring/parameter_file_text.hpp"
#include "base/files.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/tables.hpp"
#include "driver/report_unreadable.hpp"
#include "emit/concerned.hpp"
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
        tables.unreadable = report_unreadable(path, text.error(), findings) || tables.unreadable;
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

const input::PrintedTable& table_of(const ReadTables& tables, Device device) {
    return device == Device::governor ? tables.governor : tables.gateway;
}

// Either sheet of a plant says it.
std::optional<std::uint32_t> main_cycle_of(const ReadTables& tables) {
    return tables.governor.main_cycle_us ? tables.governor.main_cycle_us : tables.gateway.main_cycle_us;
}

parameter::ParameterSet set_of(const input::PrintedTable& table) {
    parameter::ParameterSet set;
    for (const auto& [number, value] : table.values) {
        parameter::Assignment assignment;
        assignment.row = value.row;
        assignment.value = value.value;
        assignment.where = value.where;
        set.assign(std::move(assignment));
    }
    return set;
}

// "Governor: not printed, taken as 0: 400, 402", in lines of a width that reads well.
void remark_absent(std::vector<std::string>& remarks, std::string_view device, const std::string& numbers) {
    constexpr std::size_t width = 90;
    if (numbers.empty()) {
        return;
    }
    std::string line = fmt::format("{}: not printed, taken as 0:", device);
    std::istringstream words(numbers);
    for (std::string word; words >> word;) {
        if (line.size() + 1 + word.size() > width) {
            remarks.push_back(line);
            line = " ";
        }
        line += " " + word;
    }
    remarks.push_back(line);
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

TableSide side_of_tables(const CheckedFile& file, const ReadTables& tables) {
    TableSide side;
    side.settings = file.settings;
    side.settings.main_cycle_us = main_cycle_of(tables).value_or(file.settings.main_cycle_us);
    for (const Device device : {Device::governor, Device::gateway}) {
        const input::PrintedTable& table = table_of(tables, device);
        parameter::ParameterSet set = set_of(table);
        for (const auto& [number, assignment] : file.settings.of(device).all()) {
            const bool is_absent = set.assign(assignment);
            if (is_absent && assignment.value != 0) {
                side.absent.push_back({assignment.row, assignment.value, 0});
            }
        }
        (device == Device::governor ? side.settings.governor : side.settings.gateway) = std::move(set);
    }
    side.configuration = config::resolve(side.settings, *file.catalogue);
    return side;
}

std::string absent_numbers(const ReadTables& tables, Device device, const parameter::Catalogue& catalogue) {
    const parameter::ParameterSet set = set_of(table_of(tables, device));
    std::string text;
    std::uint16_t first = 0;
    std::uint16_t last = 0;
    const auto close = [&] {
        if (first != 0) {
            text += text.empty() ? "" : ", ";
            text += first == last ? fmt::format("{}", first) : fmt::format("{}..{}", first, last);
        }
    };
    for (const parameter::Row* row : emit::concerned_rows(catalogue, device, set)) {
        if (set.find(row->number) != nullptr || row->minimum.value_or(0) > 0) {
            continue;
        }
        if (row->number != last + 1) {
            close();
            first = row->number;
        }
        last = row->number;
    }
    close();
    return text;
}

void note_absent_rows(ReadTables& tables, const TablePaths& paths, const parameter::Catalogue& catalogue) {
    for (const Device device : {Device::governor, Device::gateway}) {
        const std::string numbers = absent_numbers(tables, device, catalogue);
        if (numbers.empty()) {
            continue;
        }
        const std::string& path = device == Device::governor ? paths.governor : paths.gateway;
        auto report = std::find_if(tables.reports.begin(), tables.reports.end(),
                                   [&](const diagnostic::FileReport& other) { return other.path == path; });
        if (report == tables.reports.end()) {
            report = tables.reports.insert(report, {path, {}, {}});
        }
        report->findings.push_back(
            {&diagnostic::rules::table_row_absent,
             fmt::format("not printed for the {}, taken as 0: {}", parameter::to_text(device), numbers),
             {path, {}},
             {},
             "look whether these are 0 in the device"});
    }
}

std::string text_of_tables(const ReadTables& tables, const TablePaths& paths, const std::string& title,
                           const parameter::Catalogue& catalogue) {
    authoring::Draft draft;
    draft.title = !title.empty()                   ? title
                  : !tables.governor.title.empty() ? tables.governor.title
                                                   : tables.gateway.title;
    if (const std::optional<std::uint32_t> cycle = main_cycle_of(tables);
        cycle != parameter::Settings{}.main_cycle_us) {
        draft.main_cycle_us = cycle;
    }
    draft.remarks = {fmt::format("Governor: {}; gateway: {}. Read by cgw import table.",
                                 file_name(paths.governor), file_name(paths.gateway))};
    remark_absent(draft.remarks, "Governor", absent_numbers(tables, Device::governor, catalogue));
    remark_absent(draft.remarks, "Gateway", absent_numbers(tables, Device::gateway, catalogue));
    draft.governor = written(tables.governor);
    draft.gateway = written(tables.gateway);
    return authoring::parameter_file_text(draft, catalogue);
}

}  // namespace cgw::driver
