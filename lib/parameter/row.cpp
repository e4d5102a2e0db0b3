#include "parameter/row.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cgw::parameter {

std::string_view to_text(Device device) {
    return device == Device::governor ? "governor" : "gateway";
}

std::string_view to_text(Program program) {
    return program == Program::application ? "application" : "bootloader";
}

bool Row::allows(double value) const {
    if (!choices.empty()) {
        return std::any_of(choices.begin(), choices.end(),
                           [value](std::uint32_t choice) { return static_cast<double>(choice) == value; });
    }
    return std::isfinite(value) && value >= minimum.value_or(value) && value <= maximum.value_or(value);
}

std::string label(const Row& row) {
    return row.name.empty() ? fmt::format("{}", row.number) : fmt::format("{} {}", row.number, row.name);
}

double to_engineering(std::int32_t raw, std::int32_t internal_minimum, std::int32_t internal_maximum,
                      double external_minimum, double external_maximum) {
    const double steps = static_cast<double>(internal_maximum) - internal_minimum;
    const double position = static_cast<double>(raw) - internal_minimum;
    return external_minimum + position * (external_maximum - external_minimum) / steps;
}

}  // namespace cgw::parameter
