// Rows as C++ source, for the shipped catalogues.
#pragma once

#include <span>
#include <string>

#include "parameter/row.hpp"

namespace cgw::catalogue {

// A whole translation unit that defines shipped_rows() with these rows, in their order.
std::string row_source(std::span<const parameter::Row* const> rows);

}  // namespace cgw::catalogue
