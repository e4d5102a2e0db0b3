// Two resolved configurations written down by hand, so that dictionary, EDS and tables are tested without
// the parameter file: nothing active, and the manual's example (chapter 7).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "config/configuration.hpp"
#include "config/numbers.hpp"
#include "parameter/row.hpp"

namespace cgw::test {

inline parameter::Row make_row(std::uint16_t number, std::string_view name, bool is_signed = false) {
    parameter::Row row;
    row.number = number;
    row.name = name;
    row.width = 16;
    row.is_signed = is_signed;
    return row;
}

namespace row {
inline const parameter::Row speed = make_row(2000, "Speed");
inline const parameter::Row speed_setpoint = make_row(2031, "SpeedSetp");
inline const parameter::Row position = make_row(2300, "ActPos");
inline const parameter::Row position_setpoint = make_row(2330, "ActPosSetpoint");
inline const parameter::Row oil_pressure = make_row(2905, "OilPressure");
inline const parameter::Row charge_air_temperature = make_row(2908, "ChargeAirTemp", true);
inline const parameter::Row load = make_row(2917, "CurrentLoad");
inline const parameter::Row setpoint_switch = make_row(827, "FunctSetpoint2Or1");
inline const parameter::Row load_switch = make_row(835, "FunctLoadEnable");
inline const parameter::Row setpoint_1 = make_row(900, "AssignIn_Setp1Ext");
inline const parameter::Row setpoint_2 = make_row(901, "AssignIn_Setp2Ext");
inline const parameter::Row ambient_pressure = make_row(906, "AssignIn_AmbPress");
inline const parameter::Row unnamed_sensor = make_row(907, "");
inline const parameter::Row load_sensor = make_row(917, "AssignIn_CurrentLoad");
}  // namespace row

// All 20 PDOs exist and none is active; node 1.
inline config::Configuration empty_configuration() {
    config::Configuration configuration;
    configuration.governor_node = configuration.gateway_node_in_governor = 1;
    configuration.gateway_node = configuration.governor_node_in_gateway = 1;
    configuration.can1.bit_rate_kbit = configuration.governor_can.bit_rate_kbit = 250;
    configuration.can2.bit_rate_kbit = 125;
    configuration.node_id = 1;
    constexpr std::array<std::uint16_t, 20> identifiers{
        0x181, 0x281, 0x381, 0x481, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x201, 0x301, 0x401, 0x501};
    for (std::size_t i = 0; i < configuration.pdos.size(); ++i) {
        config::Pdo& pdo = configuration.pdos[i];
        pdo.direction = i < 16 ? config::Direction::transmit : config::Direction::receive;
        pdo.number = static_cast<std::uint8_t>(i < 16 ? i + 1 : i - 15);
        pdo.cob_id = identifiers[i];
        pdo.cob_id_source =
            i >= 4 && i < 16 ? config::CobIdSource::parameter : config::CobIdSource::predefined;
    }
    return configuration;
}

inline config::Pdo& tpdo(config::Configuration& configuration, std::size_t number) {
    return configuration.pdos[number - 1];
}
inline config::Pdo& rpdo(config::Configuration& configuration, std::size_t number) {
    return configuration.pdos[number + 15];
}

inline config::MappedWord error_word(std::uint8_t sub_index) {
    return {config::WordKind::errors, config::object::errors, sub_index, nullptr};
}

// Appends the word to the TPDO and its entry to 2001h or 2002h (D24), and makes the TPDO active.
inline void add_output(config::Configuration& configuration, std::size_t number, const parameter::Row& row) {
    const std::uint16_t index =
        row.is_signed ? config::object::signed_outputs : config::object::unsigned_outputs;
    std::uint8_t sub_index = 1;
    for (const config::AnalogueOutput& output : configuration.analogue_outputs) {
        sub_index = static_cast<std::uint8_t>(sub_index + (output.index == index ? 1 : 0));
    }
    config::Pdo& pdo = tpdo(configuration, number);
    pdo.active = true;
    pdo.mapping.push_back({config::WordKind::measurement, index, sub_index, &row});
    configuration.analogue_outputs.push_back(
        {&row, index, sub_index, pdo.number, static_cast<std::uint8_t>(pdo.mapping.size())});
}

inline void set_receive_mapping(config::Pdo& pdo, std::initializer_list<config::MappedWord> words) {
    pdo.active = true;
    pdo.mapping = words;
}

// Every example of chapter 7 in one configuration, with TPDO3 inactive as the manual has it.
inline config::Configuration manual_configuration() {
    using config::WordKind;
    config::Configuration configuration = empty_configuration();
    configuration.partner_node_id = 127;
    configuration.heartbeat_producer = {1000, 62, 992000};
    configuration.heartbeat_consumer = {100, 6, 96000};

    configuration.send_errors = true;
    tpdo(configuration, 1).active = tpdo(configuration, 2).active = true;
    tpdo(configuration, 1).mapping = {error_word(1), error_word(2), error_word(3), error_word(4)};
    tpdo(configuration, 2).mapping = {error_word(5), error_word(6)};
    for (const parameter::Row* const row :
         {&row::speed, &row::speed_setpoint, &row::position, &row::position_setpoint}) {
        add_output(configuration, 4, *row);
    }
    for (const parameter::Row* const row : {&row::oil_pressure, &row::charge_air_temperature, &row::load}) {
        add_output(configuration, 16, *row);
    }
    tpdo(configuration, 4).time = {16, 1, 15625};
    tpdo(configuration, 6).time = {200, 12, 187500};
    tpdo(configuration, 16).time = {100, 6, 93750};
    tpdo(configuration, 5).cob_id = 0x282;
    tpdo(configuration, 8).cob_id = 0x382;
    tpdo(configuration, 12).cob_id = 0x003;
    tpdo(configuration, 16).cob_id = 0x57F;

    configuration.switches = {{&row::setpoint_switch, 1, false}, {&row::load_switch, 5, true}};
    configuration.sensors = {
        {&row::setpoint_1, 1}, {&row::setpoint_2, 2}, {&row::ambient_pressure, 7}, {&row::load_sensor, 12}};
    configuration.highest_channel = 12;
    configuration.switches_object = configuration.sensor_flags_object = true;
    const config::MappedWord dummy{WordKind::dummy, config::dummy_index, 0, nullptr};
    const auto sensor = [](std::uint8_t channel, const parameter::Row& row) {
        return config::MappedWord{WordKind::sensor, config::object::sensors, channel, &row};
    };
    set_receive_mapping(rpdo(configuration, 1),
                        {{WordKind::switches, config::object::binary_inputs, 1, nullptr},
                         dummy,
                         {WordKind::sensor_flags, config::object::binary_inputs, 2, nullptr}});
    set_receive_mapping(rpdo(configuration, 2), {sensor(1, row::setpoint_1), sensor(2, row::setpoint_2)});
    set_receive_mapping(rpdo(configuration, 3), {dummy, dummy, sensor(7, row::ambient_pressure)});
    set_receive_mapping(rpdo(configuration, 4), {dummy, dummy, dummy, sensor(12, row::load_sensor)});
    rpdo(configuration, 2).time = {100, 6, 93750};
    rpdo(configuration, 3).time = {200, 12, 187500};
    rpdo(configuration, 4).time = {1000, 64, 1000000};
    return configuration;
}

}  // namespace cgw::test
