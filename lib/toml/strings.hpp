// String literals of TOML 1.0.
#pragma once

#include <cstddef>
#include <string>

#include "toml/source.hpp"

namespace cgw::toml {

struct StringLiteral {
    std::string content;  // escapes undone; line ends as in the file
    std::size_t end = 0;  // offset behind the closing quotes
};

// `begin` is the offset of a quote or apostrophe. Throws Complaint.
StringLiteral read_string(const Source& source, std::size_t begin, bool may_span_lines);

// What stands at `offset`, for messages: "'x'", "the end of the line", "the end of the file".
std::string describe(const Source& source, std::size_t offset);

}  // namespace cgw::toml
