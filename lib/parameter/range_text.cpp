#include "parameter/range_text.hpp"

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

}  // namespace

std::string limit_text(const Row& row, double limit) {
    return row.base == Base::hexadecimal && limit > 0
               ? fmt::format("0x{:X}", static_cast<std::uint64_t>(limit))
               : base::to_text(limit);
}

std::string range_text(const Row& row) {
    std::string text;
    if (!row.choices.empty()) {
        text = choices_text(row);
    } else if (row.minimum && row.maximum) {
        text = limit_text(row, *row.minimum) + ".." + limit_text(row, *row.maximum);
    } else if (row.minimum) {
        text = "at least " + limit_text(row, *row.minimum);
    } else if (row.maximum) {
        text = "at most " + limit_text(row, *row.maximum);
    } else {
        return "";
    }
    return row.unit.empty() ? text : fmt::format("{} {}", text, row.unit);
}

}  // namespace cgw::parameter
