#include "input/table_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/ascii.hpp"
#include "base/sheet_words.hpp"
#include "input/table_values.hpp"
#include "toml/document.hpp"

namespace cgw::input {
namespace {

struct ColumnWord {
    std::string_view word;
    Column column;
};

constexpr ColumnWord column_words[] = {
    {"device", Column::device}, {"gerät", Column::device},  {"number", Column::number},
    {"no", Column::number},     {"no.", Column::number},    {"nr", Column::number},
    {"nr.", Column::number},    {"nummer", Column::number}, {"parameter", Column::name},
    {"name", Column::name},     {"value", Column::value},   {"wert", Column::value},
    {"unit", Column::unit},     {"einheit", Column::unit},
};

// A second column of values, as whoever compares two states prints it.
constexpr std::string_view words_of_states[] = {"old", "new", "alt", "neu", "actual", "ist", "soll"};

// Columns that hold numbers and are not what is set: "Default value", "Min. value", "Standardwert".
constexpr std::string_view harmless_values[] = {"default", "min", "max", "standard", "vorgabe"};

std::optional<Column> column_of(std::string_view word) {
    if (word.empty()) {
        return std::nullopt;
    }
    for (const ColumnWord& known : column_words) {
        if (base::equal_ignoring_case(known.word, word)) {
            return known.column;
        }
    }
    return std::nullopt;
}

bool may_hold_values(std::string_view cell) {
    const std::string text = base::lowered(cell);
    const auto contains = [&text](std::string_view word) { return text.find(word) != std::string::npos; };
    const bool is_state = std::any_of(std::begin(words_of_states), std::end(words_of_states),
                                      [&text](std::string_view word) { return text == word; });
    return is_state || ((contains("value") || contains("wert")) &&
                        std::none_of(std::begin(harmless_values), std::end(harmless_values), contains));
}

std::string doubt_of(const Header& header, std::string_view cell, std::optional<Column> column) {
    if (column == Column::number) {
        return "the header names the column Number twice";
    }
    if (header.has(Column::value) && (column == Column::value || (!column && may_hold_values(cell)))) {
        return fmt::format("the header names a second column of values, {}", toml::quoted(cell));
    }
    return {};
}

}  // namespace

std::optional<Header> header_of(const CellLine& line) {
    Header header;
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const std::string& text = line.cells[i].text;
        const std::optional<Column> column = column_of(text);
        if (text == base::sheet_title_column) {
            header.title = i;
        } else if (text == base::sheet_main_cycle_column) {
            header.main_cycle = i;
        }
        if (column && !header.has(*column)) {
            header.columns[static_cast<std::size_t>(*column)] = i;
        } else if (looks_like_number(text)) {
            return std::nullopt;
        }
    }
    if (!header.has(Column::number) || !(header.has(Column::name) || header.has(Column::value))) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < line.cells.size() && header.doubt.empty(); ++i) {
        const std::string& text = line.cells[i].text;
        const std::optional<Column> column = column_of(text);
        const bool is_taken = column && header.columns[static_cast<std::size_t>(*column)] == i;
        header.doubt = is_taken ? "" : doubt_of(header, text, column);
    }
    return header;
}

}  // namespace cgw::input
