// What there is to say of a device, a row each: what can differ between two, and what a table shows of one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "dictionary/dictionary.hpp"

namespace cgw::dictionary {

inline constexpr std::string_view not_stated = "not stated";

// One thing that can differ, as text. `in_bare`: also compared where a side is bare (difference.hpp).
template <typename Of>
struct AspectRow {
    std::string_view name;
    std::string_view text;
    bool in_bare;
    std::string (*value)(const Of& of);
};

// A variable in its place; with a node number $NODEID is resolved.
struct Place {
    std::uint16_t index = 0;
    const Variable& variable;
    std::optional<std::uint8_t> node_id;
};

std::span<const AspectRow<DeviceInformation>> device_rows();
std::span<const AspectRow<Commissioning>> node_rows();
std::span<const AspectRow<Module>> module_rows();
std::span<const AspectRow<Object>> object_rows();      // of every object
std::span<const AspectRow<Object>> sub_object_rows();  // also of those with sub-objects
std::span<const AspectRow<Place>> variable_rows();
std::span<const AspectRow<Place>> set_value_rows();  // where a configuration file sets one

// Where both are configuration files.
std::span<const AspectRow<Object>> configured_object_rows();
std::span<const AspectRow<Place>> configured_variable_rows();

// A configuration file gives it another value than its default.
bool sets_value(const Place& place);

std::string dummies_text(const Dictionary& dictionary);

}  // namespace cgw::dictionary
