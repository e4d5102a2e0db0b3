#include <fmt/format.h>

#include "schema/parts.hpp"

namespace cgw::schema {
namespace {

using base::JsonWriter;
using input::Key;
using input::Limit;
using input::Presence;
using input::Table;
using toml::Kind;

std::string description(const Key& key) {
    std::string text(key.text);
    if (key.limit == Limit::value) {
        text += key.minimum == key.maximum ? fmt::format("\n\nalways {}", key.minimum)
                                           : fmt::format("\n\n{}..{}", key.minimum, key.maximum);
    }
    if (!key.preset.empty()) {
        text += fmt::format("; {} when it is not given", key.preset);
    }
    return text;
}

void write_number(JsonWriter& json, const Key& key) {
    json.key("type").string(key.kind == Kind::real ? "number" : "integer");
    if (key.limit == Limit::value && key.minimum == key.maximum) {
        json.key("const").integer(key.minimum);
    } else if (key.limit == Limit::value) {
        json.key("minimum").integer(key.minimum).key("maximum").integer(key.maximum);
    }
}

// A character has at least one byte, so a limit of bytes holds for characters too.
void write_string(JsonWriter& json, const Key& key) {
    json.key("type").string("string");
    if (!key.words.empty()) {
        json.key("enum").begin_array();
        for (const std::string_view word : key.words) {
            json.string(word);
        }
        json.end_array();
    }
    if (key.limit == Limit::bytes && key.minimum > 0) {
        json.key("minLength").integer(key.minimum);
    }
    if (key.limit == Limit::bytes) {
        json.key("maxLength").integer(key.maximum);
    }
}

void write_key(JsonWriter& json, const Key& key, const Table& table);

void write_array(JsonWriter& json, const Key& key, const Table& table) {
    json.key("type").string("array");
    if (key.limit == Limit::elements) {
        json.key("maxItems").integer(key.maximum);
    }
    json.key("items");
    if (key.element == nullptr) {
        write_reference(json, declaration);
        return;
    }
    write_key(json, *key.element, table);
    if (key.element->kind != Kind::table) {
        json.key("uniqueItems").boolean(true);
    }
}

void write_key(JsonWriter& json, const Key& key, const Table& table) {
    if (key.kind == Kind::table && key.below == nullptr) {
        write_reference(json, values_of(*table.device));
        return;
    }
    json.begin_object();
    if (!key.text.empty()) {
        json.key("description").string(description(key));
    }
    switch (key.kind) {
        case Kind::integer:
        case Kind::real:
            write_number(json, key);
            break;
        case Kind::array:
            write_array(json, key, table);
            break;
        case Kind::table:
            write_table(json, *key.below);
            break;
        case Kind::local_date:  // a string to whoever turns TOML into JSON
            json.key("type").string("string").key("pattern").string("^[0-9]{4}-[0-9]{2}-[0-9]{2}$");
            break;
        default:
            write_string(json, key);
    }
    if (!key.preset.empty()) {
        json.key("default").json(key.preset);
    }
    json.end_object();
}

// The table as a whole cannot be right without it: a file says its format, and each device has parameters
// that nobody can do without (input/required.hpp).
bool is_needed(const Key& key, const Table& table) {
    const bool is_device = key.below != nullptr && key.below->device.has_value();
    const bool is_parameters = table.device && key.kind == Kind::table && key.below == nullptr;
    return key.presence == Presence::required || key.name == "format" || is_device || is_parameters;
}

}  // namespace

void write_table(JsonWriter& json, const Table& table) {
    json.key("type").string("object").key("properties").begin_object();
    for (const Key& key : table.keys) {
        json.key(key.name);
        write_key(json, key, table);
    }
    json.end_object().key("required").begin_array();
    for (const Key& key : table.keys) {
        if (is_needed(key, table)) {
            json.string(key.name);
        }
    }
    json.end_array().key("additionalProperties").boolean(false);
}

}  // namespace cgw::schema
