// Inside the authoring room: parameters by the names that entries of 2001h, 2002h and 2004h have.
#pragma once

#include <string_view>

#include "parameter/catalogue.hpp"

namespace cgw::authoring {

// "Speed", "Speed 2" where two entries have the same parameter, "Sensor 902" (the prefix and its number) for
// a row without a name. nullptr when it is the name of none.
const parameter::Row* row_of_entry(const parameter::Catalogue& catalogue, std::string_view name,
                                   std::string_view number_prefix);

}  // namespace cgw::authoring
