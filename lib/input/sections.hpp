// The tables of the parameter file, all but the parameters themselves.
#pragma once

#include "input/context.hpp"

namespace cgw::input {

// The key at the top of the file that was probably meant to be `name`; nullptr when there is none.
const toml::Entry* misspelt_at_top(const toml::Node& document, std::string_view name);

// Reads the whole document except what it leaves in context.postponed.
void read_sections(Context& context, const toml::Node& document);

// The catalogues that the file names, then its declarations.
void read_catalogues(Context& context, const CatalogueLoader& load);
void read_declarations(Context& context);

}  // namespace cgw::input
