#include <algorithm>
#include <array>
#include <cstdlib>

#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "config/parts.hpp"
#include "config/reading.hpp"

namespace cgw::config {

namespace {

bool comes_over_canopen(const parameter::ParameterSet& set, std::uint16_t number) {
    return set.value(governor::type_of(number)) == governor::canopen_type;
}

void collect_switches(const parameter::ParameterSet& set, Configuration& configuration) {
    for (const auto& [number, assignment] : set.all()) {
        if (number < governor::first_switch || number > governor::last_switch || assignment.row == nullptr ||
            !comes_over_canopen(set, number)) {
            continue;
        }
        constexpr auto bits = static_cast<std::int32_t>(switch_bits);
        const std::int32_t bit = whole(set, number, -bits, bits);
        if (bit != 0) {
            configuration.switches.push_back({.row = assignment.row,
                                              .bit = static_cast<std::uint8_t>(std::abs(bit)),
                                              .low_active = bit < 0});
        }
    }
}

void collect_sensors(const parameter::ParameterSet& set, Configuration& configuration) {
    for (const auto& [number, assignment] : set.all()) {
        if (number < governor::first_sensor || number > governor::last_sensor || assignment.row == nullptr ||
            !comes_over_canopen(set, number)) {
            continue;
        }
        const auto channel = setting<std::uint8_t>(set, number, static_cast<std::int32_t>(sensor_channels));
        if (channel != 0) {
            configuration.sensors.push_back({.row = assignment.row, .channel = channel});
            configuration.highest_channel = std::max(configuration.highest_channel, channel);
        }
    }
}

// D25: word 1 switches, word 2 nothing, word 3 sensor flags; dummies keep the places.
void map_binary(Pdo& pdo, const Configuration& configuration) {
    const MappedWord dummy{.kind = WordKind::dummy, .index = dummy_index};
    const MappedWord switches{
        .kind = WordKind::switches, .index = object::binary_inputs, .sub_index = object::switches_sub};
    const MappedWord flags{.kind = WordKind::sensor_flags,
                           .index = object::binary_inputs,
                           .sub_index = object::sensor_flags_sub};
    const bool has_switches = !configuration.switches.empty();
    pdo.active = has_switches || !configuration.sensors.empty();
    if (!configuration.sensors.empty()) {
        pdo.mapping = {has_switches ? switches : dummy, dummy, flags};
    } else if (has_switches) {
        pdo.mapping = {switches};
    }
}

// D26: each sensor stands at the word of its channel; where two share one, the lower number is named.
void map_sensors(Pdo& pdo, const Configuration& configuration) {
    for (const Sensor& sensor : configuration.sensors) {
        if (facts::rpdo_of_channel(sensor.channel) != pdo.number) {
            continue;
        }
        const std::size_t position = facts::word_of_channel(sensor.channel) - 1U;
        if (pdo.mapping.size() <= position) {
            pdo.mapping.resize(position + 1, {.kind = WordKind::dummy, .index = dummy_index});
        }
        if (pdo.mapping[position].kind == WordKind::dummy) {
            pdo.mapping[position] = {.kind = WordKind::sensor,
                                     .index = object::sensors,
                                     .sub_index = sensor.channel,
                                     .parameter = sensor.row};
        }
    }
    pdo.active = !pdo.mapping.empty();
}

}  // namespace

void resolve_receive_pdos(const parameter::Settings& settings, Configuration& configuration) {
    collect_switches(settings.governor, configuration);
    collect_sensors(settings.governor, configuration);
    configuration.sensor_flags_object = !configuration.sensors.empty();
    configuration.switches_object = configuration.sensor_flags_object || !configuration.switches.empty();

    for (int number = 1; number <= rpdo_count; ++number) {
        Pdo& pdo = configuration.pdos[static_cast<std::size_t>(tpdo_count + number - 1)];
        pdo.direction = Direction::receive;
        pdo.number = static_cast<std::uint8_t>(number);
        pdo.cob_id = predefined_identifier(rpdo_identifier_bases[static_cast<std::size_t>(number - 1)],
                                           configuration.node_id);
        pdo.time = resolve_time(settings, parameter::Device::governor, governor::rpdo_monitoring_of(number),
                                configuration.main_cycle_us, pdo.number, configuration);
        if (number == 1) {
            map_binary(pdo, configuration);
        } else {
            map_sensors(pdo, configuration);
        }
    }
}

}  // namespace cgw::config
