// Texts that users wrote, as cells of the forms in which tables are emitted.
#pragma once

#include <string>
#include <string_view>

namespace cgw::emit {

// A cell or heading of Markdown: one line, nothing in it is markup, '|' ends no cell.
std::string markdown_cell(std::string_view text);

// A field of CSV (RFC 4180, section 2); what a spreadsheet would run as a formula begins with an apostrophe.
std::string csv_field(std::string_view text);

}  // namespace cgw::emit
