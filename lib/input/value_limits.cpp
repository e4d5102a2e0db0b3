#include "input/value_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace cgw::input {

using parameter::Row;

namespace {

std::string with_unit(const Row& row) {
    return row.unit.empty() ? "" : fmt::format(" {}", row.unit);
}

std::string limit_text(const Row& row, double limit) {
    return row.base == parameter::Base::hexadecimal && limit >= 0
               ? fmt::format("0x{:X}", static_cast<std::uint64_t>(limit))
               : base::to_text(limit);
}

}  // namespace

std::string objection(const Row& row, double value) {
    if (!row.choices.empty()) {
        const auto is_value = [&](std::uint32_t choice) { return static_cast<double>(choice) == value; };
        return std::any_of(row.choices.begin(), row.choices.end(), is_value)
                   ? ""
                   : fmt::format("none of {}{}", fmt::join(row.choices, ", "), with_unit(row));
    }
    const bool is_low = row.minimum && !(value >= *row.minimum);
    const bool is_high = row.maximum && !(value <= *row.maximum);
    if (is_low || is_high) {
        if (row.minimum && row.maximum) {
            return fmt::format("outside {}..{}{}", limit_text(row, *row.minimum),
                               limit_text(row, *row.maximum), with_unit(row));
        }
        return fmt::format("{} {}{}", is_low ? "below" : "above",
                           limit_text(row, is_low ? *row.minimum : *row.maximum), with_unit(row));
    }
    return std::isfinite(value) ? "" : "not a finite number";
}

}  // namespace cgw::input
