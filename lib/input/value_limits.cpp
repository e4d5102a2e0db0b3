#include "input/value_limits.hpp"

#include <fmt/format.h>

#include "parameter/value_text.hpp"

namespace cgw::input {

std::string objection(const parameter::Row& row, double value) {
    if (row.allows(value)) {
        return "";
    }
    if (!row.choices.empty()) {
        return "none of " + range_text(row);
    }
    if (row.minimum && row.maximum) {
        return "outside " + range_text(row);
    }
    if (row.minimum && !(value >= *row.minimum)) {
        return "below " + quantity_text(row, *row.minimum);
    }
    if (row.maximum && !(value <= *row.maximum)) {
        return "above " + quantity_text(row, *row.maximum);
    }
    return "not a finite number";
}

}  // namespace cgw::input
