// A draft becomes rows of the catalogue: arrays are expanded, known rows filled, the result checked.
#pragma once

#include "catalogue/cells.hpp"
#include "parameter/catalogue.hpp"

namespace cgw::catalogue {

// `draft` has a number. Adds its rows and returns the first; nullptr when an array cannot be one.
// Rows are added after findings too, so that one mistake does not bring others behind it.
const parameter::Row* merge(const Draft& draft, bool declaration, parameter::Catalogue& catalogue,
                            const Reporter& report);

// The parameters that `external` of this row's table names are settable ones of the device.
void check_references(const toml::Node& table, parameter::Device device,
                      const parameter::Catalogue& catalogue, const Reporter& report);

}  // namespace cgw::catalogue
