// A dictionary as an XML device description (XDD), or as the configuration of one node (XDC): CiA 311,
// version 1.1, UTF-8. What is written reads back as the same dictionary, but for what docs/conversions.md
// lists.
//
// Both dialects in one: every object carries its type, access, default, limits and value, and links to a
// parameter that says the same in the words of IEC 61131-3; what has no word there (DOMAIN, INTEGER24) is a
// BITSTRING. Objects with sub-objects have no parameter. Values are spelt as in an EDS (eds/value_text.hpp),
// $NODEID included.
//
// Elements that the schema declares globally are in its name space, the others in none, as its version 1.1
// demands.
#pragma once

#include <string>

#include "dictionary/dictionary.hpp"

namespace cgw::xdd {

std::string write(const dictionary::Dictionary& dictionary);
std::string write(const dictionary::Dictionary& dictionary, const dictionary::Commissioning& node);

}  // namespace cgw::xdd
