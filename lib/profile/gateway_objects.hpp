// Inside the profile room: how the gateway profile's files share its object rows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"

namespace cgw::profile {

struct Limits {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
};

// One VAR or sub-object as the manual's EDS prints it; what depends on the configuration is 0 here.
struct VariableRow {
    std::uint8_t sub_index = 0;
    std::string_view name;
    object::DataType type = object::DataType::unsigned8;
    std::uint32_t value = 0;
    bool node_id_relative = false;
    bool run_time = false;
};

struct ObjectRow {
    std::uint16_t index = 0;
    std::string_view name;
    object::ObjectCode code = object::ObjectCode::var;
    std::span<const VariableRow> variables;
};

inline constexpr std::string_view number_of_entries = "Number of Entries";

dictionary::Object object_of(const ObjectRow& row);

// "Number of Entries" with its limits: the sub 0 of what the configuration sizes.
dictionary::Variable entry_count(std::string_view name, std::size_t count, Limits limits);

// 1400h.., 1600h.. or 1800h.., 1A00h.. of one direction, ascending.
std::vector<dictionary::Object> pdo_objects(const config::Configuration& configuration,
                                            config::Direction direction);

// 2000h–2005h.
std::vector<dictionary::Object> process_data_objects(const config::Configuration& configuration);

}  // namespace cgw::profile
