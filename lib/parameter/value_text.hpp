// A parameter's values and its range as people read and type them.
#pragma once

#include <string>

#include "parameter/row.hpp"

namespace cgw::parameter {

// A value or a limit in the row's number base, as a parameter file takes it: "15.625", "127", "0x7FF"; 0 is
// "0" in both bases.
std::string value_text(const Row& row, double value);

// The same with the row's unit: "15.625 ms", "0x282".
std::string quantity_text(const Row& row, double value);

// "1..31", "0..100 s", "125, 250, 500 or 1000 kbit/s", "at least 0 %", "0..0x7FF". Without limits the unit
// alone; empty when nothing is known.
std::string range_text(const Row& row);

}  // namespace cgw::parameter
