#include "driver/check_sheet.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace cgw::driver {
namespace {

DataSheet checked(DataSheet file, eds_check::Options options) {
    if (!file.sheet) {
        return file;
    }
    if (options.file_name.empty() && file.path != "-") {
        options.file_name = std::filesystem::path(file.path).filename().string();
    }
    eds_check::check(*file.document, *file.sheet, file.path, options, file.findings);
    file.findings.sort();
    return file;
}

}  // namespace

DataSheet check_data_sheet(const std::string& path, eds_check::Options options) {
    return checked(read_data_sheet(path), std::move(options));
}

DataSheet check_data_sheet_text(const std::string& path, std::string text, eds_check::Options options) {
    return checked(read_data_sheet_text(path, std::move(text)), std::move(options));
}

std::size_t count_repairable(const diagnostic::Findings& findings) {
    const auto row_of = [](const diagnostic::Diagnostic& finding) {
        return eds_check::find_check(finding.rule);
    };
    const auto& all = findings.all();
    if (std::any_of(all.begin(), all.end(), [&](const auto& finding) {
            return row_of(finding) != nullptr && row_of(finding)->doubtful;
        })) {
        return 0;
    }
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](const auto& finding) {
        return row_of(finding) != nullptr && row_of(finding)->repair != nullptr;
    }));
}

}  // namespace cgw::driver
