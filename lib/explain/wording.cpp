#include "explain/wording.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.hpp"

namespace cgw::explain {

std::string_view to_text(parameter::List list) {
    constexpr std::array<std::string_view, 4> names{"parameter", "measurement", "function", "curve"};
    return names.at(static_cast<std::size_t>(list));
}

std::string program_text(parameter::Device device, parameter::Program program) {
    const std::string_view name = to_text(device);
    return program == parameter::Program::application ? std::string(name)
                                                      : fmt::format("{} bootloader", name);
}

std::string value_text(double value, parameter::Base base) {
    const bool whole = value >= 0 && value <= 0xFFFFFFFF && std::floor(value) == value;
    if (base == parameter::Base::hexadecimal && whole && value != 0) {
        return fmt::format("{:X}h", static_cast<std::uint64_t>(value));
    }
    return base::to_text(value);
}

std::string range_text(const parameter::Row& row) {
    std::string text;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const bool last = i + 1 == row.choices.size();
        text += fmt::format("{}{}", i == 0 ? "" : last ? " or " : ", ", row.choices[i]);
    }
    if (text.empty() && row.minimum && row.maximum) {
        text = fmt::format("{}..{}", value_text(*row.minimum, row.base), value_text(*row.maximum, row.base));
    }
    if (!row.unit.empty()) {
        text += fmt::format("{}{}", text.empty() ? "" : " ", row.unit);
    }
    return text;
}

std::string object_text(unsigned index) {
    return fmt::format("{:04X}h", index);
}

std::string object_text(unsigned index, unsigned sub) {
    return fmt::format("{:04X}h:{}", index, sub);
}

}  // namespace cgw::explain
