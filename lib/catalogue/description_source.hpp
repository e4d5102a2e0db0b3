// Descriptions as C++ source, for the tables compiled in.
#pragma once

#include <span>
#include <string>

#include "catalogue/errors.hpp"
#include "catalogue/objects.hpp"

namespace cgw::catalogue {

// Whole translation units that define shipped_errors() and shipped_objects(), in the given order.
std::string error_source(std::span<const ErrorDescription> errors);
std::string object_source(std::span<const ObjectDescription> objects);

}  // namespace cgw::catalogue
