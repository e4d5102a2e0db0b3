#include "explain/table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/numbers.hpp"
#include "base/text_cells.hpp"
#include "base/utf8.hpp"
#include "explain/text.hpp"

namespace cgw::explain {

namespace {

using Row = std::vector<std::string>;

constexpr std::size_t gap = 2;          // blanks between columns
constexpr std::size_t narrowest = 28;   // of the last column; otherwise it moves to lines of its own
constexpr std::size_t indentation = 4;  // of those lines

std::vector<std::size_t> shown_columns(const Table& table, unsigned where) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if ((table.columns[i].shown & where) != 0) {
            shown.push_back(i);
        }
    }
    return shown;
}

// Consecutive rows with the same first cell; one group without a name when the table is not grouped.
struct Group {
    std::string name;
    std::vector<const Row*> rows;
};

std::vector<Group> groups_of(const Table& table) {
    std::vector<Group> groups;
    for (const Row& row : table.rows) {
        const std::string name = table.grouped ? row.front() : std::string();
        if (groups.empty() || groups.back().name != name) {
            groups.push_back({name, {}});
        }
        groups.back().rows.push_back(&row);
    }
    return groups;
}

// Without the columns in which nothing stands.
std::vector<std::size_t> filled_columns(const Group& group, std::vector<std::size_t> columns) {
    std::erase_if(columns, [&](std::size_t column) {
        return std::all_of(group.rows.begin(), group.rows.end(),
                           [column](const Row* row) { return (*row)[column].empty(); });
    });
    return columns;
}

// --- table ---

// One group with its title line; columns are as wide as this group needs.
class TextTable {
  public:
    TextTable(const Table& table, const Group& group)
        : table_(table), group_(group), shown_(shown_columns(table, in_text)) {
        for (const std::size_t column : shown_) {
            std::size_t width = 0;
            for (const Row* row : group.rows) {
                width = std::max(width, base::width_of((*row)[column]));
            }
            const bool empty = width == 0;  // nobody misses it
            widths_.push_back(empty ? 0 : std::max(width, base::width_of(table.columns[column].title)));
            offset_ += column != shown_.back() && !empty ? widths_.back() + gap : 0;
        }
        below_ = offset_ + std::min(narrowest, widths_.back()) > page_width;
    }

    std::string render() {
        Row titles;
        for (const Column& column : table_.columns) {
            titles.emplace_back(column.title);
        }
        append(titles);
        for (const Row* row : group_.rows) {
            append(*row);
        }
        return text_;
    }

  private:
    void append(const Row& row) {
        std::string line;
        for (std::size_t i = 0; i + 1 < shown_.size(); ++i) {
            if (widths_[i] != 0) {
                const std::string& cell = row[shown_[i]];
                line += cell + std::string(widths_[i] - base::width_of(cell) + gap, ' ');
            }
        }
        const std::size_t indent = below_ ? indentation : offset_;
        if (below_) {
            append_line(line);
            line = std::string(indent, ' ');
        }
        const bool empty = widths_.back() == 0;  // then its title goes as well
        for (const std::string& part : wrap(empty ? "" : row[shown_.back()], page_width - indent)) {
            append_line(line + part);
            line = std::string(indent, ' ');
        }
    }

    void append_line(std::string_view line) {
        const std::size_t end = line.find_last_not_of(' ');
        if (end != std::string_view::npos) {
            text_ += fmt::format("{}\n", line.substr(0, end + 1));
        }
    }

    const Table& table_;
    const Group& group_;
    std::vector<std::size_t> shown_;
    std::vector<std::size_t> widths_;
    std::size_t offset_ = 0;  // column in which the last one starts
    bool below_ = false;      // the last column stands below its row
    std::string text_;
};

std::string render_text(const Table& table) {
    std::string text;
    for (const Group& group : groups_of(table)) {
        if (!group.name.empty()) {
            text += fmt::format("{}{}\n\n", text.empty() ? "" : "\n", group.name);
        }
        text += TextTable(table, group).render();
    }
    return text;
}

// --- Markdown ---

std::string render_page(const Table& table) {
    return render_markdown(table, 2);
}

// --- JSON, CSV ---

void append_json_cell(base::JsonWriter& json, const Column& column, const std::string& cell) {
    if (!column.number) {
        json.string(cell);
    } else if (const auto integer = base::parse_integer(cell)) {
        json.integer(*integer);
    } else if (const auto real = base::parse_real(cell)) {
        json.real(*real);
    } else {
        json.null();
    }
}

std::string render_json(const Table& table) {
    const std::vector<std::size_t> shown = shown_columns(table, in_data);
    base::JsonWriter json;
    json.begin_object().key("format_version").integer(1).key(table.name).begin_array();
    for (const Row& row : table.rows) {
        json.begin_object();
        for (const std::size_t column : shown) {
            json.key(table.columns[column].key);
            append_json_cell(json, table.columns[column], row[column]);
        }
        json.end_object();
    }
    json.end_array().end_object();
    return json.take();
}

// RFC 4180: lines end with CR LF.
std::string render_csv(const Table& table) {
    const std::vector<std::size_t> shown = shown_columns(table, in_data);
    std::string text;
    const auto append = [&](auto cell_of) {
        for (const std::size_t column : shown) {
            text += (column != shown.front() ? "," : "") + base::csv_field(cell_of(column));
        }
        text += "\r\n";
    };
    append([&](std::size_t column) { return table.columns[column].key; });
    for (const Row& row : table.rows) {
        append([&](std::size_t column) { return std::string_view(row[column]); });
    }
    return text;
}

constexpr std::array formats{
    TableFormat{"table", "columns for a terminal", true, render_text},
    TableFormat{"json", "one object per row", false, render_json},
    TableFormat{"csv", "comma-separated values (RFC 4180)", false, render_csv},
    TableFormat{"md", "Markdown tables", true, render_page},
};

}  // namespace

std::string render_markdown(const Table& table, std::size_t level) {
    std::vector<std::size_t> shown;
    std::string text;
    const auto append = [&](auto cell_of) {
        for (const std::size_t column : shown) {
            text += fmt::format("| {} ", cell_of(column));
        }
        text += "|\n";
    };
    for (const Group& group : groups_of(table)) {
        if (!group.name.empty()) {
            text += fmt::format("{}{} {}\n\n", text.empty() ? "" : "\n", std::string(level, '#'), group.name);
        }
        shown = filled_columns(group, shown_columns(table, in_page));
        append([&](std::size_t column) { return std::string(table.columns[column].title); });
        append([](std::size_t) { return std::string("---"); });
        for (const Row* row : group.rows) {
            append([&](std::size_t column) { return base::markdown_cell((*row)[column]); });
        }
    }
    return text;
}

std::span<const TableFormat> table_formats() {
    return formats;
}

const TableFormat* find_table_format(std::string_view name) {
    const auto* const found = std::find_if(formats.begin(), formats.end(),
                                           [&](const TableFormat& format) { return format.name == name; });
    return found != formats.end() ? found : nullptr;
}

}  // namespace cgw::explain
