// The tables of the parameter file, all but the parameters themselves.
#pragma once

#include "input/context.hpp"
#include "input/table_reader.hpp"

namespace cgw::input {

// The top of the file, and from there every table with fixed keys. Tables of parameters have none, and belong
// to the device of the table they stand in; `declare` holds declarations (catalogue/cells.hpp).
const Table& file_table();

// The key at the top of the file that was probably meant to be `name`; nullptr when there is none.
const toml::Entry* misspelt_at_top(const toml::Node& document, std::string_view name);

// Reads the whole document except what it leaves in context.postponed.
void read_sections(Context& context, const toml::Node& document);

// One name in the file's list of catalogues.
inline constexpr Key catalogue_name = {.name = "a catalogue's name",
                                       .kind = toml::Kind::string,
                                       .limit = Limit::bytes,
                                       .minimum = 1,
                                       .maximum = 4096,
                                       .text = "path of a catalogue file, relative to this file"};

// The catalogues that the file names, then its declarations.
void read_catalogues(Context& context, const CatalogueLoader& load);
void read_declarations(Context& context);

}  // namespace cgw::input
