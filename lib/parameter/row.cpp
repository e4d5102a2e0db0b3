#include "parameter/row.hpp"

#include <fmt/format.h>

namespace cgw::parameter {

std::string_view to_text(Device device) {
    return device == Device::governor ? "governor" : "gateway";
}

std::string_view to_text(Program program) {
    return program == Program::application ? "application" : "bootloader";
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
