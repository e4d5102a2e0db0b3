#include "driver/check_sheet.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace cgw::driver {
namespace {

// "": standard input, whose name is not known.
std::string file_name_of(const std::string& path) {
    return path == "-" ? "" : std::filesystem::path(path).filename().string();
}

DataSheet checked(DataSheet file, eds_check::Options options) {
    if (!file.sheet) {
        return file;
    }
    if (options.file_name.empty()) {
        options.file_name = file_name_of(file.path);
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

std::size_t count_repairs(const DataSheet& file) {
    const auto& all = file.findings.all();
    const bool may_be_repaired =
        file.sheet && std::any_of(all.begin(), all.end(), [](const diagnostic::Diagnostic& finding) {
            const eds_check::Check* const row = eds_check::find_check(finding.rule);
            return row != nullptr && row->repair != nullptr;
        });
    return may_be_repaired
               ? eds_check::fix(file.document->text(), file.path, {.file_name = file_name_of(file.path)})
                     .repairs.size()
               : 0;
}

}  // namespace cgw::driver
