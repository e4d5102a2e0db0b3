// The diagnostic view as text: both connections, then every measurement by number and name; at most 80
// columns.
#pragma once

#include <string>

#include "runtime/diagnosis.hpp"

namespace cgw::runtime {

std::string status_page(const Diagnosis& diagnosis);

}  // namespace cgw::runtime
