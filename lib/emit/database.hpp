// The CAN database of a plant before it is printed.
#pragma once

#include "dbc/database.hpp"
#include "emit/emitter.hpp"

namespace cgw::emit {

// The gateway is its first node, the partner the second.
dbc::Database database_of(const Plant& plant);

}  // namespace cgw::emit
