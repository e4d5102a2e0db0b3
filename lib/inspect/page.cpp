#include "inspect/page.hpp"

#include <fmt/format.h>

#include "inspect/fields.hpp"

namespace cgw::inspect {
namespace {

std::string field_table(const Record& record) {
    std::string table = "| Offset | Field | Type | Meaning |\n|---|---|---|---|\n";
    for (const Field& field : record.fields) {
        table += fmt::format("| {} | {} | {} | {} |\n", field.offset, field.name, type_text(field),
                             full_text(field));
    }
    return table;
}

std::string section_table() {
    std::string table = "| Id | Section | Record size | Records | Holds |\n|---|---|---|---|---|\n";
    for (const Record& record : all_records()) {
        if (record.is_section()) {
            table += fmt::format("| {} | `{}` | {} | {} | {} |\n", static_cast<unsigned>(record.section),
                                 record.name, record.size, record.count_text, record.about);
        }
    }
    return table;
}

// What belongs below a heading; "" when that has no table of ours.
std::string table_below(std::string_view heading) {
    if (heading == "## Sections") {
        return section_table();
    }
    for (const Record& record : all_records()) {
        const std::string mark = fmt::format("### `{}`", record.name);
        if (heading.starts_with(mark) && !record.fields.empty()) {
            return field_table(record);
        }
    }
    return "";
}

}  // namespace

std::string with_tables(std::string_view page) {
    std::string made;
    std::string due;         // below the last heading
    bool replacing = false;  // within the old table
    while (!page.empty()) {
        const std::string_view line = page.substr(0, page.find('\n'));
        page.remove_prefix(std::min(line.size() + 1, page.size()));
        if (line.starts_with("#")) {
            due = table_below(line);
        }
        replacing = line.starts_with("|") && (replacing || !due.empty());
        if (!replacing) {
            made += fmt::format("{}\n", line);
        } else {
            made += due;
            due.clear();
        }
    }
    return made;
}

}  // namespace cgw::inspect
