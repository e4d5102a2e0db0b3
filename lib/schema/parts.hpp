// The parts of the schema, one file each.
#pragma once

#include <string>
#include <string_view>

#include "base/json.hpp"
#include "input/table_reader.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::schema {

// {"$ref": "#/definitions/NAME"}
void write_reference(base::JsonWriter& json, std::string_view name);

// Names of definitions: what a device's parameters take, the spellings they may have, one parameter.
std::string values_of(parameter::Device device);
std::string names_of(parameter::Device device);
inline constexpr std::string_view declaration = "declaration";

// What the keys of a table are and of all tables below it; into an object that is begun.
void write_table(base::JsonWriter& json, const input::Table& table);

// Definitions, each with its key.
void write_parameters(base::JsonWriter& json, const parameter::Catalogue& catalogue,
                      parameter::Device device);
void write_declaration(base::JsonWriter& json);

}  // namespace cgw::schema
