// A printed parameter table as lines of cells, whatever separates them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostic/location.hpp"

namespace cgw::input {

enum class Separation : std::uint8_t { tabs, commas, bars, semicolons, blanks };

struct Cell {
    std::string text;         // without blanks around it, quotes and markup
    diagnostic::Range range;  // as it stands in the file
    std::string whole{};      // the text with what may be markup
};

struct CellLine {
    std::uint32_t number = 0;  // 1-based
    Separation separation = Separation::blanks;
    std::vector<Cell> cells;  // none: a blank line
    diagnostic::Range range;  // without blanks around it
};

// `line` has no line end; `skipped` bytes stood before it in its line (a byte order mark). The separator of
// the table's header, where it had one, separates if the line has any; else tabs, bars (Markdown),
// semicolons, and at last blanks. Commas do so only when the header did. Where tabs, commas or semicolons
// separate, a cell may stand in double quotes (RFC 4180).
CellLine split_cells(std::string_view line, std::uint32_t number, std::optional<Separation> header,
                     std::size_t skipped = 0);

// The text of a cell without what surrounds names in manuals and Markdown: <i>…</i>, *…*, backslashes before
// punctuation; no-break spaces become blanks.
std::string plain_text(std::string_view cell);

}  // namespace cgw::input
