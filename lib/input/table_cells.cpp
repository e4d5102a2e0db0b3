#include "input/table_cells.hpp"
#include "base/ascii.hpp"

#include <algorithm>
#include <array>

namespace cgw::input {
namespace {

constexpr std::string_view blanks = " \t\f\r";

std::string_view trimmed(std::string_view text) {
    return base::trimmed(text, blanks);
}

// Length of the markup at the start of `text`, 0 for none.
std::size_t markup_length(std::string_view text) {
    constexpr std::array<std::string_view, 8> tags = {"<i>", "</i>", "<b>",  "</b>",
                                                      "<u>", "</u>", "<br>", "<em>"};
    for (const std::string_view tag : tags) {
        if (text.starts_with(tag)) {
            return tag.size();
        }
    }
    return text.front() == '*' || text.front() == '`' ? 1 : 0;
}

// U+00A0, U+2007, U+202F
std::size_t no_break_space_length(std::string_view text) {
    constexpr std::array<std::string_view, 3> spaces = {"\xC2\xA0", "\xE2\x80\x87", "\xE2\x80\xAF"};
    const auto* const space = std::find_if(spaces.begin(), spaces.end(),
                                           [text](std::string_view s) { return text.starts_with(s); });
    return space != spaces.end() ? space->size() : 0;
}

bool is_punctuation(char c) {
    return c > ' ' && c < '\x7F' &&
           std::string_view("!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~").find(c) != std::string_view::npos;
}

std::string unquoted(std::string_view cell) {
    std::string text;
    for (std::size_t at = 1; at < cell.size(); ++at) {
        if (cell[at] == '"' && (at + 1 == cell.size() || cell[++at] != '"')) {
            break;
        }
        text += cell[at];
    }
    return text;
}

// Where the cell that begins at `at` ends: at the separator, or at the end of the line.
std::size_t cell_end(std::string_view line, std::size_t at, char separator, bool with_quotes) {
    const std::size_t first = std::min(line.find_first_not_of(' ', at), line.size());
    bool inside = false;
    const bool is_quoted = with_quotes && first < line.size() && line[first] == '"';
    for (; at < line.size(); ++at) {
        if (is_quoted && line[at] == '"') {
            inside = !inside;
        } else if (separator == '|' && line[at] == '\\') {
            ++at;
        } else if (line[at] == separator && !inside) {
            break;
        }
    }
    return std::min(at, line.size());
}

class Splitter {
  public:
    Splitter(std::string_view line, std::uint32_t number, std::size_t skipped)
        : line_(line), number_(number), skipped_(skipped) {}

    diagnostic::Range range(std::size_t begin, std::size_t end) const {
        const auto column = [this](std::size_t at) { return static_cast<std::uint32_t>(at + skipped_ + 1); };
        return {{number_, column(begin)}, {number_, column(end)}};
    }

    diagnostic::Range range_of(std::string_view part) const {
        const auto begin = static_cast<std::size_t>(part.data() - line_.data());
        return range(begin, begin + part.size());
    }

    std::vector<Cell> at_separators(char separator) const {
        const bool with_quotes = separator != '|';
        std::vector<Cell> cells;
        std::size_t at = 0;
        while (true) {
            const std::size_t end = cell_end(line_, at, separator, with_quotes);
            add(cells, line_.substr(at, end - at), with_quotes);
            if (end == line_.size()) {
                return cells;
            }
            at = end + 1;
        }
    }

    // "CanOpTPDO4-16Cyc (11)" is one cell although a blank stands in it (D3).
    std::vector<Cell> at_blanks() const {
        std::vector<Cell> cells;
        std::size_t at = std::min(line_.find_first_not_of(blanks), line_.size());
        while (at < line_.size()) {
            std::size_t end = std::min(line_.find_first_of(blanks, at), line_.size());
            const std::size_t next = std::min(line_.find_first_not_of(blanks, end), line_.size());
            const bool has_index = cells.size() == 1 && next + 1 < line_.size() && line_[next] == '(' &&
                                   base::is_digit(line_[next + 1]);
            end = has_index ? std::min(line_.find_first_of(blanks, next), line_.size()) : end;
            add(cells, line_.substr(at, end - at), false);
            at = std::min(line_.find_first_not_of(blanks, end), line_.size());
        }
        return cells;
    }

  private:
    void add(std::vector<Cell>& cells, std::string_view raw, bool with_quotes) const {
        const std::string_view cell = trimmed(raw);
        const bool is_quoted = with_quotes && cell.starts_with('"');
        std::string whole = is_quoted ? unquoted(cell) : std::string(cell);
        std::string text = plain_text(whole);
        for (std::string* const marked : {&text, &whole}) {
            if (with_quotes && marked->starts_with('\'')) {
                marked->erase(0, 1);  // how a spreadsheet marks what is text and no formula
            }
        }
        cells.push_back({std::move(text), range_of(cell), std::move(whole)});
    }

    std::string_view line_;
    std::uint32_t number_;
    std::size_t skipped_;
};

struct Separator {
    Separation separation;
    char character;
};

// In the order in which they are looked for.
constexpr std::array separators{Separator{Separation::tabs, '\t'}, Separator{Separation::commas, ','},
                                Separator{Separation::bars, '|'}, Separator{Separation::semicolons, ';'}};

Separation separation_of(std::string_view line, std::optional<Separation> header) {
    std::optional<Separation> found;
    for (const Separator& candidate : separators) {
        // A tab at the end of a line separates nothing.
        const std::string_view part = candidate.separation == Separation::tabs ? trimmed(line) : line;
        const bool is_there = part.find(candidate.character) != std::string_view::npos;
        if (is_there && header == candidate.separation) {
            return candidate.separation;
        }
        if (is_there && !found && candidate.separation != Separation::commas) {
            found = candidate.separation;
        }
    }
    return found.value_or(Separation::blanks);
}

// "| a | b |": the outer bars separate nothing.
void drop_outer(std::vector<Cell>& cells) {
    if (cells.size() > 1 && cells.back().text.empty()) {
        cells.pop_back();
    }
    if (cells.size() > 1 && cells.front().text.empty()) {
        cells.erase(cells.begin());
    }
}

}  // namespace

std::string plain_text(std::string_view cell) {
    // What markup, escapes and no-break spaces begin with; all before the next one is copied at once.
    constexpr std::string_view special = "<*`\\\xC2\xE2";
    std::string text;
    while (!cell.empty()) {
        if (const std::size_t plain = std::min(cell.find_first_of(special), cell.size()); plain > 0) {
            text += cell.substr(0, plain);
            cell.remove_prefix(plain);
        } else if (const std::size_t markup = markup_length(cell); markup > 0) {
            cell.remove_prefix(markup);
        } else if (const std::size_t space = no_break_space_length(cell); space > 0) {
            text += ' ';
            cell.remove_prefix(space);
        } else {
            const bool is_escape = cell.front() == '\\' && cell.size() > 1 && is_punctuation(cell[1]);
            cell.remove_prefix(is_escape ? 1 : 0);
            text += cell.front();
            cell.remove_prefix(1);
        }
    }
    return std::string(trimmed(text));
}

CellLine split_cells(std::string_view line, std::uint32_t number, std::optional<Separation> header,
                     std::size_t skipped) {
    const Splitter splitter(line, number, skipped);
    CellLine result;
    result.number = number;
    const std::string_view solid = trimmed(line);
    result.range = splitter.range_of(solid);
    if (solid.empty()) {
        return result;
    }
    result.separation = separation_of(line, header);
    const auto separator = std::find_if(
        separators.begin(), separators.end(),
        [&result](const Separator& candidate) { return candidate.separation == result.separation; });
    result.cells =
        separator != separators.end() ? splitter.at_separators(separator->character) : splitter.at_blanks();
    if (result.separation == Separation::bars && solid.starts_with('|')) {
        drop_outer(result.cells);
    }
    return result;
}

}  // namespace cgw::input
