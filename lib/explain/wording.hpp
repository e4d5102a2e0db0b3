// How parts of a row are put into words, alike in lists, explanations and pages.
#pragma once

#include <string>
#include <string_view>

#include "base/canopen_text.hpp"
#include "parameter/row.hpp"
#include "parameter/value_text.hpp"

namespace cgw::explain {

using base::object_text;

std::string_view to_text(parameter::List list);  // "parameter", "measurement", "function", "curve"

// "gateway", "gateway bootloader"
std::string program_text(parameter::Device device, parameter::Program program);

}  // namespace cgw::explain
