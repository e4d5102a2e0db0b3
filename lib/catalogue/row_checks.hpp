// What a row lacks or cannot be, once its draft is merged with what is known.
#pragma once

#include "catalogue/cells.hpp"

namespace cgw::catalogue {

// Reports what is wrong with `row`, which is `draft` merged into `known` (nullptr: a new number), and leaves
// it such that its use brings no second finding and no scaling that cannot be.
void check_row(parameter::Row& row, const parameter::Row* known, const Draft& draft, bool declaration,
               const Reporter& report);

// Gives a row of unknown kind the list that its cells or its number suggest, and lets it take any value.
void stand_in(parameter::Row& row, const Draft& draft);

// The refused kind is a switch or a sensor, which have a second number.
bool names_a_pair(const Draft& draft);

}  // namespace cgw::catalogue
