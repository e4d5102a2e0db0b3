#include "driver/data_sheet.hpp"

#include <utility>

#include "base/files.hpp"
#include "driver/report_unreadable.hpp"

namespace cgw::driver {

DataSheet read_data_sheet(const std::string& path) {
    base::Result<std::string> text = base::read_file(path, eds::largest_text);
    if (text) {
        return read_data_sheet_text(path, std::move(*text));
    }
    DataSheet file;
    file.path = path;
    file.unreadable = report_unreadable(path, text.error(), file.findings);
    return file;
}

DataSheet read_data_sheet_text(const std::string& path, std::string text) {
    DataSheet file;
    file.path = path;
    file.document = std::make_unique<eds::Document>(std::move(text));
    file.sheet = eds::read(*file.document, path, file.findings);
    file.sources[path] = file.document->text();
    file.findings.sort();
    return file;
}

}  // namespace cgw::driver
