// The canonical text (settings.hpp) read back: what an image keeps of its parameter file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameter/settings.hpp"

namespace cgw::parameter {

// A declared row as its line tells it. Texts are owned, so that rows can be made of it.
struct CanonicalRow {
    Device device = Device::governor;
    std::uint16_t number = 0;
    std::string name;
    List list = List::parameter;
    Role role = Role::none;
    std::uint8_t width = 0;
    bool is_signed = false;
    std::string unit;
    std::optional<Scaling> scaling;

    Row row() const;  // refers to the texts of this
};

struct CanonicalValue {
    Device device = Device::governor;
    std::uint16_t number = 0;
    double value = 0;
};

struct CanonicalModel {
    std::string title;
    Identity identity;
    std::uint32_t main_cycle_us = 0;
    std::vector<CanonicalRow> rows;
    std::vector<CanonicalValue> values;  // by device and number
};

// nullopt where a line has not the form that canonical_text() gives it, or the first is another. Order and
// repetition are not looked at.
std::optional<CanonicalModel> read_canonical_text(std::string_view text);

}  // namespace cgw::parameter
