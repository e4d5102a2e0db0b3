// How a parameter may be spelled as a key (docs/parameter-file.md, "Parameters"; D2, D3, D13, D16).
#pragma once

#include <string>
#include <vector>

#include "parameter/catalogue.hpp"

namespace cgw::schema {

// "16404", "CanOpTPDO5-16ID(0)", "16404 CanOpTPDO5-16ID(0)"; for element (0) the array's bare name as well.
std::vector<std::string> canonical_spellings(const parameter::Row& row);

// A regular expression for every spelling that means the row while no other rows are there: any case,
// aliases, misprints, blanks. Only what ECMA 262, Python and Rust read alike.
std::string spelling_pattern(const parameter::Row& row, const parameter::Catalogue& catalogue);

}  // namespace cgw::schema
