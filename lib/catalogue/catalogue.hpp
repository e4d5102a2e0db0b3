// The shipped rows, and the reader of catalogue files (schemas/parameters/*.toml and a user's own).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "diagnostic/diagnostic.hpp"
#include "parameter/catalogue.hpp"
#include "toml/document.hpp"

namespace cgw::catalogue {

// Rows of schemas/parameters/*.toml, sorted by device and number, compiled into the program.
std::span<const parameter::Row> shipped_rows();

// Adds the rows of a user's catalogue file to `catalogue`. A row may fill blanks of a row that is there;
// contradicting a filled cell is a finding. Returns false when there was an error.
bool read_catalogue(std::string_view text, const std::string& path, parameter::Catalogue& catalogue,
                    diagnostic::Findings& findings);

// One [[governor.declare]] table (the same cells as a catalogue's measurement row, named as in the
// parameter file); nullptr after a finding.
const parameter::Row* read_declaration(const toml::Node& table, const std::string& path,
                                       parameter::Catalogue& catalogue, diagnostic::Findings& findings);

}  // namespace cgw::catalogue
