#include "parameter/value_text.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "base/numbers.hpp"

namespace cgw::parameter {
namespace {

std::string choices_text(const Row& row) {
    std::string text;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const std::string_view before = i == 0 ? "" : i + 1 == row.choices.size() ? " or " : ", ";
        text += fmt::format("{}{}", before, row.choices[i]);
    }
    return text;
}

std::string limits_text(const Row& row) {
    if (row.minimum && row.maximum) {
        return value_text(row, *row.minimum) + ".." + value_text(row, *row.maximum);
    }
    if (row.minimum) {
        return "at least " + value_text(row, *row.minimum);
    }
    return row.maximum ? "at most " + value_text(row, *row.maximum) : "";
}

std::string with_unit(std::string text, const Row& row) {
    if (row.unit.empty()) {
        return text;
    }
    return text.empty() ? std::string(row.unit) : fmt::format("{} {}", text, row.unit);
}

}  // namespace

std::string value_text(const Row& row, double value) {
    const bool is_whole = value > 0 && value <= 0xFFFFFFFF && std::floor(value) == value;
    return row.base == Base::hexadecimal && is_whole
               ? fmt::format("0x{:X}", static_cast<std::uint32_t>(value))
               : base::to_text(value);
}

std::string quantity_text(const Row& row, double value) {
    return with_unit(value_text(row, value), row);
}

std::string range_text(const Row& row) {
    return with_unit(row.choices.empty() ? limits_text(row) : choices_text(row), row);
}

}  // namespace cgw::parameter
