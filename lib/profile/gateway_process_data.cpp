#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cctype>

#include "config/numbers.hpp"
#include "dictionary/ascii.hpp"
#include "facts/gateway.hpp"
#include "profile/gateway_objects.hpp"

namespace cgw::profile {
namespace {

using dictionary::Object;
using dictionary::Variable;
using object::Access;
using object::DataType;
using object::ObjectCode;

// An object whose entries the configuration decides.
struct ProcessObjectRow {
    std::uint16_t index;
    std::string_view name;
    DataType type;   // of its entries
    Access access;   // of its entries (D29)
    Limits entries;  // of sub 0
};

constexpr ProcessObjectRow digital_outputs{
    config::object::errors, "Digital Outputs", DataType::unsigned16, Access::ro, {6, 7}};
constexpr ProcessObjectRow unsigned_outputs{config::object::unsigned_outputs,
                                            "Unsigned Analog Outputs",
                                            DataType::unsigned16,
                                            Access::ro,
                                            {0, facts::maximum_outputs}};
constexpr ProcessObjectRow signed_outputs{config::object::signed_outputs,
                                          "Signed Analog Outputs",
                                          DataType::integer16,
                                          Access::ro,
                                          {0, facts::maximum_outputs}};
constexpr ProcessObjectRow digital_inputs{
    config::object::binary_inputs, "Digital Inputs", DataType::unsigned16, Access::rww, {0, 2}};
constexpr ProcessObjectRow analog_inputs{config::object::sensors,
                                         "Analog Inputs",
                                         DataType::unsigned16,
                                         Access::rww,
                                         {0, config::sensor_channels}};

constexpr std::string_view engine_state = "Engine State";  // D20, D22
constexpr std::array<std::string_view, 6> error_words{"Errors 0-15",  "Errors 16-31", "Errors 32-47",
                                                      "Errors 48-63", "Errors 64-79", "Errors 80-95"};
constexpr std::array<std::string_view, 2> input_words{"Switch Functions", "Sensor Error Flags"};  // D25

constexpr std::array canopen_errors{VariableRow{0, "CanOpen Errors", DataType::unsigned16, 0, false, true}};
constexpr ObjectRow canopen_errors_object{facts::object::canopen_errors, "CanOpen Errors", ObjectCode::var,
                                          canopen_errors};

// Entries 1, 2, … with these names.
Object process_object(const ProcessObjectRow& row, const std::vector<std::string>& names) {
    Object object;
    object.index = row.index;
    object.name = row.name;
    object.code = ObjectCode::array;
    object.variables.push_back(entry_count("Number of entries", names.size(), row.entries));
    for (const std::string& name : names) {
        Variable& entry = object.variables.emplace_back();
        entry.sub_index = static_cast<std::uint8_t>(object.variables.size() - 1);
        entry.name = name;
        entry.type = row.type;
        entry.access = row.access;
        entry.pdo_mapping = true;
        entry.run_time = true;
    }
    return object;
}

// What code generators make of a name: equal identifiers would not compile.
std::string identifier_of(std::string_view name) {
    std::string identifier(name);
    std::transform(identifier.begin(), identifier.end(), identifier.begin(), [](unsigned char c) {
        return static_cast<char>(std::isalnum(c) != 0 ? std::tolower(c) : '_');
    });
    return identifier;
}

// D43: "Speed", "Speed 2", …, never equal to another name of the list.
std::vector<std::string> made_unique(const std::vector<std::string>& names) {
    std::vector<std::string> unique;
    std::vector<std::string> taken;
    for (const std::string& name : names) {
        std::string candidate = name;
        for (int count = 2; std::ranges::find(taken, identifier_of(candidate)) != taken.end(); ++count) {
            candidate = fmt::format("{} {}", name, count);
        }
        taken.push_back(identifier_of(candidate));
        unique.push_back(std::move(candidate));
    }
    return unique;
}

// Rows without a name (D13) get their number instead.
std::string name_of(const parameter::Row* row, std::string_view kind) {
    if (row == nullptr) {
        return std::string(kind);
    }
    return row->name.empty() ? fmt::format("{} {}", kind, row->number) : dictionary::to_ascii(row->name);
}

std::vector<std::string> digital_output_names(const config::Configuration& configuration) {
    std::vector<std::string> names(error_words.begin(), error_words.end());
    if (configuration.send_status) {
        names.emplace_back(engine_state);
    }
    return names;
}

std::vector<std::string> analogue_output_names(const config::Configuration& configuration,
                                               std::uint16_t index) {
    std::vector<std::string> names;
    for (const config::AnalogueOutput& output : configuration.analogue_outputs) {
        if (output.index == index) {
            names.push_back(name_of(output.parameter, "Parameter"));
        }
    }
    return made_unique(names);
}

std::vector<std::string> digital_input_names(const config::Configuration& configuration) {
    std::size_t count = 0;
    if (configuration.sensor_flags_object) {
        count = config::object::sensor_flags_sub;
    } else if (configuration.switches_object) {
        count = config::object::switches_sub;
    }
    return {input_words.begin(), input_words.begin() + static_cast<std::ptrdiff_t>(count)};
}

// D26: one entry per channel up to the highest used one; a shared channel is named after its first sensor.
std::vector<std::string> analogue_input_names(const config::Configuration& configuration) {
    std::vector<std::string> names;
    for (std::uint8_t channel = 1; channel <= configuration.highest_channel; ++channel) {
        const auto sensor = std::ranges::find(configuration.sensors, channel, &config::Sensor::channel);
        names.push_back(sensor != configuration.sensors.end() ? name_of(sensor->row, "Sensor")
                                                              : fmt::format("Unused Channel {}", channel));
    }
    return made_unique(names);
}

}  // namespace

std::vector<Object> process_data_objects(const config::Configuration& configuration) {
    return {
        process_object(digital_outputs, digital_output_names(configuration)),
        process_object(unsigned_outputs, analogue_output_names(configuration, unsigned_outputs.index)),
        process_object(signed_outputs, analogue_output_names(configuration, signed_outputs.index)),
        process_object(digital_inputs, digital_input_names(configuration)),
        process_object(analog_inputs, analogue_input_names(configuration)),
        object_of(canopen_errors_object),
    };
}

}  // namespace cgw::profile
