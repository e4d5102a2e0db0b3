// The columns of a CSV table, each heading beside what stands below it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/text_cells.hpp"

namespace cgw::base {

template <typename Line>
struct Column {
    std::string_view heading;
    std::string (*cell)(const Line& line);
};

template <typename Line>
std::string csv_heading(std::span<const Column<Line>> columns) {
    std::string text;
    for (const Column<Line>& column : columns) {
        text += text.empty() ? "" : ",";
        text += csv_field(column.heading);
    }
    return text + '\n';
}

template <typename Line>
std::string csv_line(std::span<const Column<Line>> columns, const Line& line) {
    std::string text;
    for (const Column<Line>& column : columns) {
        text += &column == &columns.front() ? "" : ",";
        text += csv_field(column.cell(line));
    }
    return text + '\n';
}

}  // namespace cgw::base
