#include "emit/pdo_rows.hpp"

#include <fmt/format.h>
#include <algorithm>

namespace cgw::emit {
namespace {

using config::WordKind;

std::vector<Carried> switches_of(const config::Configuration& configuration) {
    std::vector<Carried> carried;
    for (const config::SwitchFunction& function : configuration.switches) {
        carried.push_back({function.row, function.bit, function.low_active});
    }
    return carried;
}

// The flag of channel k is bit k of RPDO1's word 3 (D25), so that all sensors stand behind it.
std::vector<Carried> sensors_of(const config::Configuration& configuration, const config::MappedWord& word) {
    std::vector<Carried> carried;
    for (const config::Sensor& sensor : configuration.sensors) {
        if (word.kind == WordKind::sensor_flags || sensor.channel == word.sub_index) {
            carried.push_back({sensor.row, sensor.channel, false});
        }
    }
    return carried;
}

std::vector<Carried> carried_by(const config::Configuration& configuration, const config::MappedWord& word) {
    std::vector<Carried> carried;
    if (word.kind == WordKind::switches) {
        carried = switches_of(configuration);
    } else if (word.kind == WordKind::sensor_flags || word.kind == WordKind::sensor) {
        carried = sensors_of(configuration, word);
    }
    std::stable_sort(carried.begin(), carried.end(),
                     [](const Carried& a, const Carried& b) { return a.position < b.position; });
    return carried;
}

std::string object_name(const dictionary::Dictionary& dictionary, const config::MappedWord& word) {
    const dictionary::Variable* const variable = dictionary.find(word.index, word.sub_index);
    return variable != nullptr ? variable->name : "dummy";
}

WordRow word_row(const Plant& plant, const config::MappedWord& word) {
    WordRow row;
    row.kind = word.kind;
    row.index = word.index;
    row.sub_index = word.sub_index;
    row.name = object_name(plant.dictionary, word);
    row.label = row.name;
    if (word.parameter != nullptr) {
        row.parameter = word.parameter->number;
        if (!word.parameter->name.empty()) {
            row.name = word.parameter->name;
            row.label = parameter::label(*word.parameter);
        }
    }
    row.carried = carried_by(plant.configuration, word);
    return row;
}

PdoRow pdo_row(const Plant& plant, const config::Pdo& pdo) {
    PdoRow row;
    row.name = pdo.name();
    row.pdo = &pdo;
    for (const config::MappedWord& word : pdo.mapping) {
        row.words.push_back(word_row(plant, word));
        row.words.back().position = static_cast<std::uint8_t>(row.words.size());
    }
    return row;
}

}  // namespace

PdoTable pdo_table(const Plant& plant) {
    PdoTable table;
    table.title = plant.settings.title;
    table.configuration_id = plant.configuration_id_text;
    table.node_id = plant.configuration.node_id;
    for (const config::Pdo& pdo : plant.configuration.pdos) {
        table.rows.push_back(pdo_row(plant, pdo));
    }
    return table;
}

std::string describe(config::WordKind kind, const Carried& carried) {
    std::string label = parameter::label(*carried.row);
    if (kind != WordKind::sensor) {
        label = fmt::format("bit {}{}: {}", carried.position, carried.low_active ? " low-active" : "", label);
    }
    return label;
}

}  // namespace cgw::emit
