// How parts of a row are put into words, alike in lists, explanations and pages.
#pragma once

#include <string>
#include <string_view>

#include "parameter/row.hpp"

namespace cgw::explain {

std::string_view to_text(parameter::List list);  // "parameter", "measurement", "function", "curve"

// "gateway", "gateway bootloader"
std::string program_text(parameter::Device device, parameter::Program program);

// A value as the manual prints it: "7FFh" for a hexadecimal parameter, else "15.625".
std::string value_text(double value, parameter::Base base);

// "0..7FFh", "0..100 s", "125, 250, 500 or 1000 kbit/s"; "" when the row has no range.
std::string range_text(const parameter::Row& row);

// "2000h", "2000h:5"
std::string object_text(unsigned index);
std::string object_text(unsigned index, unsigned sub);

}  // namespace cgw::explain
