// Changes of values in a text as a unified diff, which patch -p0 applies; everything around them stays.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"

namespace cgw::authoring {

// What stands in the range, on one line, becomes `text`.
struct Edit {
    diagnostic::Range where;
    std::string text;
};

// The text with all edits made. Edits do not overlap; one that does not fit the text is left out.
std::string edited(std::string_view text, std::vector<Edit> edits);

// The difference, three lines of context around each change; empty without edits. `path` as patch is to find
// the file.
std::string unified_diff(std::string_view path, std::string_view text, const std::vector<Edit>& edits);

}  // namespace cgw::authoring
