// The header of a printed table: which cell of its rows is which column.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "input/table_cells.hpp"

namespace cgw::input {

enum class Column : std::uint8_t { device, number, name, value, unit };

// Place of each column, by Column; absent ones have none.
using Columns = std::array<std::optional<std::size_t>, 5>;

inline constexpr Columns usual_columns = {std::nullopt, 0, 1, 2, 3};

struct Header {
    Columns columns{};
    std::optional<std::size_t> title{};       // as cgw's own sheets have it in every row
    std::optional<std::size_t> main_cycle{};  // likewise, in microseconds
    std::string doubt;  // why the rows below cannot be read with certainty; "" when they can

    bool has(Column column) const { return columns[static_cast<std::size_t>(column)].has_value(); }
};

// A line is a header when it names the column Number and one of Parameter and Value, and holds no number.
std::optional<Header> header_of(const CellLine& line);

}  // namespace cgw::input
