// A list as columns and rows, and its renderers: every `cgw list` is one Table, every format one row here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::explain {

// Where a column is shown; combine with |.
enum Shown : unsigned {
    in_text = 1,  // the table on a terminal
    in_page = 2,  // Markdown
    in_data = 4,  // JSON and CSV
    everywhere = in_text | in_page | in_data,
};

struct Column {
    std::string_view key;    // of JSON and CSV: "cob_id"
    std::string_view title;  // for people
    unsigned shown = everywhere;
    bool number = false;  // JSON number; an empty cell is null
};

struct Table {
    std::string_view name;  // of the JSON array: "parameters"
    // For people, rows are grouped under headings: the cells of the first column, which is shown nowhere
    // else.
    bool grouped = false;
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;  // as many cells as columns, one line each
};

struct TableFormat {
    std::string_view name;  // "table", "md", "json", "csv"
    std::string_view summary;
    bool for_people;
    std::string (*render)(const Table& table);
};

// "table" is the first one.
std::span<const TableFormat> table_formats();
const TableFormat* find_table_format(std::string_view name);  // nullptr: there is none

// Markdown with the headings of groups at this level ("##"); render of the format "md" is level 2.
std::string render_markdown(const Table& table, std::size_t level);

}  // namespace cgw::explain
