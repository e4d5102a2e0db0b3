// Every finding cgw can make. Only what explains, lists or documents all of them includes this.
#pragma once

#include <span>

#include "diagnostic/rule.hpp"

namespace cgw::diagnostic {

// All rules of all groups, sorted by code.
std::span<const Rule* const> all_rules();

}  // namespace cgw::diagnostic
