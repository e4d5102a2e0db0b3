// A declaration as a parameter file has it.
#pragma once

#include <string>

#include "parameter/row.hpp"

namespace cgw::authoring {

// "[[governor.declare]]" with the cells that the row fills, after a blank line. What a declaration cannot say
// is left out: the kind of a row that ships with cgw and is none of measurement, switch and sensor, and the
// name of an array's element, "Name(0)".
std::string declaration_text(const parameter::Row& row);

}  // namespace cgw::authoring
