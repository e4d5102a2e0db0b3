// The objects as a table for people and for spreadsheets.
#include <fmt/format.h>

#include <array>

#include "base/text_cells.hpp"
#include "base/utf8.hpp"
#include "convert/writing.hpp"
#include "dictionary/data_types.hpp"
#include "dictionary/difference_rows.hpp"
#include "dictionary/value_text.hpp"
#include "eds/value_text.hpp"

namespace cgw::convert {
namespace {

using dictionary::Object;
using dictionary::Value;
using dictionary::Variable;

struct Row {
    const Object& object;
    const Variable* variable;  // nullptr: the object as a whole
};

// How a table writes a value of that type.
using ValueText = std::string (*)(object::DataType type, const Value& value);

std::string for_people(object::DataType type, const Value& value) {
    return dictionary::value_text(type, value);
}
std::string for_programs(object::DataType type, const Value& value) {
    return eds::value_text(value, dictionary::row_of(type));
}

std::string text_of(const std::optional<Value>& value, const Variable& variable, ValueText text) {
    return value ? text(variable.type, *value) : "";
}

struct Column {
    std::string_view heading;
    std::string (*cell)(const Row& row, ValueText text);
};

constexpr std::array columns{
    Column{"Index", [](const Row& row, ValueText) { return fmt::format("{:04X}h", row.object.index); }},
    Column{"Sub-index",
           [](const Row& row, ValueText) {
               const bool is_sub_object = row.variable != nullptr && has_sub_objects(row.object.code);
               return is_sub_object ? fmt::format("{}", row.variable->sub_index) : std::string();
           }},
    Column{"Name",
           [](const Row& row, ValueText) {
               const bool is_sub_object = row.variable != nullptr && has_sub_objects(row.object.code);
               return is_sub_object ? row.variable->name : row.object.name;
           }},
    Column{"Object",
           [](const Row& row, ValueText) {
               const bool is_sub_object = row.variable != nullptr && has_sub_objects(row.object.code);
               return is_sub_object ? std::string()
                                    : std::string(dictionary::object_code_text(row.object.code));
           }},
    Column{"Type",
           [](const Row& row, ValueText) {
               return row.variable != nullptr ? std::string(dictionary::row_of(row.variable->type).name) : "";
           }},
    Column{"Access",
           [](const Row& row, ValueText) {
               return row.variable != nullptr ? std::string(dictionary::access_text(row.variable->access))
                                              : "";
           }},
    Column{"PDO mapping",
           [](const Row& row, ValueText) {
               return std::string(row.variable == nullptr ? "" : row.variable->pdo_mapping ? "yes" : "no");
           }},
    Column{"Default",
           [](const Row& row, ValueText text) {
               return row.variable == nullptr || row.variable->no_default
                          ? std::string()
                          : text(row.variable->type, row.variable->default_value);
           }},
    Column{"Low limit",
           [](const Row& row, ValueText text) {
               return row.variable == nullptr ? "" : text_of(row.variable->low_limit, *row.variable, text);
           }},
    Column{"High limit",
           [](const Row& row, ValueText text) {
               return row.variable == nullptr ? "" : text_of(row.variable->high_limit, *row.variable, text);
           }},
    Column{"Value",
           [](const Row& row, ValueText text) {
               return row.variable == nullptr ? ""
                                              : text_of(row.variable->parameter_value, *row.variable, text);
           }},
};

template <typename Take>
void each_row(const std::vector<Object>& objects, Take take) {
    for (const Object& object : objects) {
        if (has_sub_objects(object.code) || object.variables.empty()) {
            take(Row{object, nullptr});
        }
        for (const Variable& variable : object.variables) {
            take(Row{object, &variable});
        }
    }
}

void append_fact(std::string& text, std::string_view name, std::string_view fact) {
    if (!fact.empty()) {
        text += fmt::format("- {}: {}\n", name, base::markdown_cell(base::to_utf8(fact)));
    }
}

template <typename Of>
void append_facts(std::string& text, std::span<const dictionary::AspectRow<Of>> rows, const Of& of) {
    for (const dictionary::AspectRow<Of>& row : rows) {
        append_fact(text, row.text, row.value(of));
    }
}

// "01-31-2026 09:00AM, somebody"
std::string moment(const std::string& date, const std::string& time, const std::string& by) {
    const std::string when = date + (date.empty() || time.empty() ? "" : " ") + time;
    return when + (when.empty() || by.empty() ? "" : ", ") + by;
}

}  // namespace

base::Bytes write_markdown(const Description& description) {
    const dictionary::DeviceInformation& device = description.dictionary.device;
    const dictionary::FileInformation& file = description.dictionary.file;
    std::string text = fmt::format("# {}\n\n", base::markdown_cell(base::to_utf8(device.product_name)));
    append_facts<dictionary::DeviceInformation>(text, dictionary::device_rows(), device);
    append_fact(text, "file", file.file_name);
    append_fact(text, "description", file.description);
    append_fact(text, "version",
                fmt::format("{}.{}, EDS {}", file.file_version, file.file_revision, file.eds_version));
    append_fact(text, "created", moment(file.creation_date, file.creation_time, file.created_by));
    append_fact(text, "modified", moment(file.modification_date, file.modification_time, file.modified_by));
    if (description.node) {
        append_facts<dictionary::Commissioning>(text, dictionary::node_rows(), *description.node);
    }
    text += "\n|";
    for (const Column& column : columns) {
        text += fmt::format(" {} |", column.heading);
    }
    text += "\n|";
    for (std::size_t i = 0; i < columns.size(); ++i) {
        text += "---|";
    }
    text += '\n';
    each_row(description.dictionary.objects, [&text](const Row& row) {
        text += '|';
        for (const Column& column : columns) {
            text += fmt::format(" {} |", base::markdown_cell(base::to_utf8(column.cell(row, for_people))));
        }
        text += '\n';
    });
    return base::to_bytes(text);
}

base::Bytes write_csv(const Description& description) {
    std::string text;
    const auto append = [&text](std::string_view cell, bool is_first) {
        text += is_first ? "" : ",";
        text += base::csv_field(base::to_utf8(cell));
    };
    for (const Column& column : columns) {
        append(column.heading, &column == columns.begin());
    }
    text += "\r\n";
    each_row(description.dictionary.objects, [&](const Row& row) {
        for (const Column& column : columns) {
            append(column.cell(row, for_programs), &column == columns.begin());
        }
        text += "\r\n";
    });
    return base::to_bytes(text);
}

}  // namespace cgw::convert
