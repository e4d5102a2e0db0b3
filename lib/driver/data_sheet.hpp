// An EDS or DCF of any device from its path to a dictionary, with the text it stands in.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "diagnostic/diagnostic.hpp"
#include "eds/document.hpp"
#include "eds/reader.hpp"

namespace cgw::driver {

struct DataSheet {
    std::string path;
    std::unique_ptr<eds::Document> document;  // both are there unless the file could not be read
    std::optional<eds::Sheet> sheet;
    diagnostic::Findings findings;               // sorted by place
    std::map<std::string, std::string> sources;  // by path: the file's text
    bool unreadable = false;                     // exit code 3

    // The sheet holds all that the file says.
    bool valid() const { return sheet.has_value() && !findings.has_errors(); }
};

// Path "-" is standard input; at most eds::largest_text bytes.
DataSheet read_data_sheet(const std::string& path);

// The same for a text that is or will be the file `path`.
DataSheet read_data_sheet_text(const std::string& path, std::string text);

}  // namespace cgw::driver
