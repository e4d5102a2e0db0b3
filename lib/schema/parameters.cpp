#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/required.hpp"
#include "parameter/value_text.hpp"
#include "schema/parts.hpp"
#include "schema/spelling.hpp"

namespace cgw::schema {
namespace {

using base::JsonWriter;
using parameter::Catalogue;
using parameter::Device;
using parameter::Row;

std::string name_of(const Row& row) {
    return fmt::format("{}{}", to_text(row.device), row.number);
}

// How many values a list may have that begins at the row; 0: it takes no list.
int list_size(const Row& row) {
    return row.array_first == 0
               ? 0
               : std::max(row.array_first + row.array_size - 1, int{row.list_end}) - row.number + 1;
}

bool same_values(const Row& a, const Row& b) {
    return a.decimal == b.decimal && a.minimum == b.minimum && a.maximum == b.maximum &&
           std::equal(a.choices.begin(), a.choices.end(), b.choices.begin(), b.choices.end());
}

const input::Required* find_required(const Row& row) {
    const auto* const end = std::end(input::required_parameters);
    const auto* const found =
        std::find_if(std::begin(input::required_parameters), end, [&](const input::Required& required) {
            return required.device == row.device && required.number == row.number;
        });
    return found == end ? nullptr : found;
}

std::string presence(const Row& row) {
    const input::Required* required = find_required(row);
    if (required == nullptr) {
        return "0 when it is not given";
    }
    return required->manual_timing == 0 ? "required"
                                        : fmt::format("required unless {} is 1", required->manual_timing);
}

// Markdown, as editors show it.
std::string description(const Row& row, int values) {
    std::string facts = parameter::range_text(row);
    const auto add = [&](const std::string& fact) { facts += facts.empty() ? fact : "; " + fact; };
    if (row.decimal) {
        add("takes fractions");
    }
    add(presence(row));
    if (row.base == parameter::Base::hexadecimal) {
        add("hexadecimal, write 0x");
    }
    if (values > 1) {
        add(fmt::format("a list fills {}..{}", row.number, row.number + values - 1));
    }
    std::string text = fmt::format("**{}** of the {}", parameter::label(row), to_text(row.device));
    for (const std::string_view part : {row.text, std::string_view(facts), row.section}) {
        text += part.empty() ? "" : fmt::format("\n\n{}", part);
    }
    return text;
}

// Type and range of one value. `or_list`: a list may stand in its place.
void write_value(JsonWriter& json, const Row& row, bool or_list) {
    const std::string_view type = row.decimal ? "number" : "integer";
    json.key("type");
    if (or_list) {
        json.begin_array().string(type).string("array").end_array();
    } else {
        json.string(type);
    }
    if (!row.choices.empty() && !or_list) {  // an enumeration would have to hold the lists
        json.key("enum").begin_array();
        for (const std::uint32_t choice : row.choices) {
            json.integer(choice);
        }
        json.end_array();
        return;
    }
    if (row.minimum) {
        json.key("minimum").real(*row.minimum);
    }
    if (row.maximum) {
        json.key("maximum").real(*row.maximum);
    }
}

// The values of a list have the range of the row it begins at, where all have the same.
void write_list(JsonWriter& json, const Row& row, const Catalogue& catalogue, int values) {
    bool all_same = true;
    for (int i = 1; i < values; ++i) {
        const Row* other = catalogue.find(row.device, static_cast<std::uint16_t>(row.number + i));
        all_same = all_same && other != nullptr && same_values(row, *other);
    }
    json.key("items").begin_object();
    json.key("description").string(description(row, values));  // what editors show for a key that has a list
    if (all_same) {
        write_value(json, row, false);
    } else {
        json.key("type").string("number");
    }
    json.end_object();
    json.key("minItems").integer(1).key("maxItems").integer(values);
}

void write_row(JsonWriter& json, const Row& row, const Catalogue& catalogue) {
    const int values = list_size(row);
    const bool may_be_zero =
        row.choices.empty() && row.minimum.value_or(0) <= 0 && row.maximum.value_or(0) >= 0;
    json.key(name_of(row)).begin_object();
    json.key("title").string(parameter::label(row));
    json.key("description").string(description(row, values));
    write_value(json, row, values > 0);
    if (values > 0) {
        write_list(json, row, catalogue, values);
    }
    if (may_be_zero && find_required(row) == nullptr) {
        json.key("default").integer(0);
    }
    json.end_object();
}

void write_values(JsonWriter& json, const Catalogue& catalogue, Device device) {
    json.key(values_of(device)).begin_object();
    json.key("description")
        .string(fmt::format("parameters of the {}, by number, by name or by both", to_text(device)));
    json.key("type").string("object").key("properties").begin_object();
    for (const Row* row : catalogue.rows(device)) {
        for (const std::string& spelling : canonical_spellings(*row)) {
            if (row->settable()) {
                json.key(spelling);
                write_reference(json, name_of(*row));
            }
        }
    }
    json.end_object();
    json.key("additionalProperties")
        .json(R"({"type":["number","array"],"items":{"type":"number"},"minItems":1})");
    json.end_object();
}

void write_names(JsonWriter& json, const Catalogue& catalogue, Device device) {
    json.key(names_of(device)).begin_object().key("type").string("object");
    json.key("patternProperties").begin_object();
    for (const Row* row : catalogue.rows(device)) {
        if (row->settable()) {
            json.key(spelling_pattern(*row, catalogue)).boolean(true);
        }
    }
    json.end_object().key("additionalProperties").boolean(false).end_object();
}

}  // namespace

std::string values_of(Device device) {
    return fmt::format("{}Parameters", to_text(device));
}

std::string names_of(Device device) {
    return fmt::format("{}Names", to_text(device));
}

void write_parameters(JsonWriter& json, const Catalogue& catalogue, Device device) {
    write_values(json, catalogue, device);
    write_names(json, catalogue, device);
    for (const Row* row : catalogue.rows(device)) {
        if (row->settable()) {
            write_row(json, *row, catalogue);
        }
    }
}

}  // namespace cgw::schema
