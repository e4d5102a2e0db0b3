// A parameter's range as people read it.
#pragma once

#include <string>

#include "parameter/row.hpp"

namespace cgw::parameter {

// A limit in the row's number base: "127", "0x7FF".
std::string limit_text(const Row& row, double limit);

// "1..31", "0..100 s", "125, 250, 500 or 1000 kbit/s", "at least 0 %", "0..0x7FF"; empty when nothing is
// known.
std::string range_text(const Row& row);

}  // namespace cgw::parameter
