// Which parameters of a device concern CANopen, whether a parameter file names them or not.
#pragma once

#include <vector>

#include "parameter/catalogue.hpp"
#include "parameter/settings.hpp"

namespace cgw::emit {

// Ascending by number: what `set` assigns, and what decides what the Gateway does. Bit-timing registers
// belong to it only with manual timing, and bit rates only without.
std::vector<const parameter::Row*> concerned_rows(const parameter::Catalogue& catalogue,
                                                  parameter::Device device,
                                                  const parameter::ParameterSet& set);

}  // namespace cgw::emit
