// Whether a number is one that its parameter can have.
#pragma once

#include <string>

#include "parameter/row.hpp"

namespace cgw::input {

// "outside 1..31", "outside 0..100 s", "none of 125, 250, 500 or 1000 kbit/s"; empty when the value is
// allowed.
std::string objection(const parameter::Row& row, double value);

}  // namespace cgw::input
