// The JSON Schema (draft-07) of the parameter file, for editors: completion, hover texts, checks while
// typing.
//
// It is never stricter than cgw: what `cgw check` accepts fits the schema. The reverse does not hold; a
// schema cannot compare two parameters, and these are looser on purpose:
//   other spellings of a parameter (lower case, aliases) take any number; numbers, canonical names and
//   "NNN Name" have the range of their row
//   parameters that no catalogue knows are refused only where the file names no catalogue and declares
//   nothing parameters that are missing, and the same one twice by different spellings, are left to cgw
#pragma once

#include <string>

#include "parameter/catalogue.hpp"

namespace cgw::schema {

// `catalogue` holds the shipped rows. Pretty-printed JSON, the same for the same rows.
std::string parameter_file_schema(const parameter::Catalogue& catalogue);

}  // namespace cgw::schema
