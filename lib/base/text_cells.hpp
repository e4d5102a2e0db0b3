// Texts as cells of the forms in which tables are written.
#pragma once

#include <string>
#include <string_view>

namespace cgw::base {

// Control characters become blanks.
std::string one_line(std::string_view text);

// A cell or heading of Markdown: one line, nothing in it is markup, '|' ends no cell.
std::string markdown_cell(std::string_view text);

// What markdown_cell was given, but for its control characters.
std::string markdown_text(std::string_view cell);

// Text of HTML and XML, also within quotes: one line, nothing in it is markup.
std::string html_text(std::string_view text);

// A field of CSV (RFC 4180, section 2). What a spreadsheet would run as a formula begins with an apostrophe;
// numbers, negative ones as well, stay numbers.
std::string csv_field(std::string_view text);

}  // namespace cgw::base
