// The shipped rows, and the reader of catalogue files (schemas/parameters/*.toml and a user's own).
//
// A catalogue file says `device = "governor"` or "gateway", may name its `profile`, and holds [[row]] tables.
// The cells are described at the top of schemas/parameters/canopen-gateway.toml; cells.cpp has them as a
// table. A row whose number is known already fills that row's blanks; contradicting a filled cell is a
// finding that shows both values (D13). Every mistake is a finding with its place:
//   key-unknown, key-type, key-missing   a cell that is unknown, of a wrong type, or lacking
//   key-value                            device, profile or kind is not one of the known words
//   declaration-invalid                  a cell's value cannot be: number outside 1..29999, a limit pair the
//   wrong
//                                        way round, width against internal limits, a number or name twice, …
//   declaration-contradiction            see above
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

// Whether a file is meant to be a catalogue and not a parameter file: it has rows or a device, and nothing
// that a parameter file must have.
bool is_catalogue(const toml::Node& root);

// Adds the rows of a catalogue file to `catalogue`. Returns false when there was an error; rows that could be
// understood are added even then, so that one mistake does not bring others behind it.
bool read_catalogue(std::string_view text, const std::string& path, parameter::Catalogue& catalogue,
                    diagnostic::Findings& findings);

// The same for a text that is parsed already.
bool read_catalogue(const toml::Node& root, const std::string& path, parameter::Catalogue& catalogue,
                    diagnostic::Findings& findings);

// One [[governor.declare]] table: the cells number, name, kind, unit, width, signed, internal, external and
// bit of a catalogue's row, with kind "measurement", "switch" (811..849, 4811..4849) or "sensor" (900..929,
// 4900..4929). `name` and `kind` may be left out where the number is known already. Returns nullptr after a
// finding; the row may be in the catalogue even then, as above.
const parameter::Row* read_declaration(const toml::Node& table, const std::string& path,
                                       parameter::Catalogue& catalogue, diagnostic::Findings& findings);

}  // namespace cgw::catalogue
