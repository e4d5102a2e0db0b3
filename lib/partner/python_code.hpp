// Inside the partner room: what every Python form says, whatever the plant: it reads the tables that stand
// before it.
#pragma once

#include <string_view>

namespace cgw::partner {

extern const std::string_view python_code;

}  // namespace cgw::partner
