// A small gateway configuration made by hand, independent of files and catalogues: TPDO1, 2, 4 and 5, RPDO1
// to 3, two switches, two sensors, heartbeats both ways.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "config/configuration.hpp"
#include "dictionary/dictionary.hpp"
#include "image_writer/image_writer.hpp"
#include "parameter/settings.hpp"

namespace cgw::test {

inline parameter::Row measurement(std::uint16_t number, std::string_view name, std::uint8_t width,
                                  bool is_signed) {
    parameter::Row row;
    row.number = number;
    row.name = name;
    row.list = parameter::List::measurement;
    row.width = width;
    row.is_signed = is_signed;
    return row;
}

inline parameter::Row input_row(std::uint16_t number, std::string_view name, parameter::Role role) {
    parameter::Row row;
    row.number = number;
    row.name = name;
    row.role = role;
    return row;
}

// Rows are referred to by address, so the plant cannot be copied or moved.
class SamplePlant {
  public:
    SamplePlant() {
        rows();
        buses();
        transmit();
        receive();
        objects();
        settings.title = "Genset 2, starboard – Größe";
        for (std::size_t i = 0; i < configuration_id.size(); ++i) {
            configuration_id[i] = static_cast<std::uint8_t>(0xA0 + i);
        }
    }
    SamplePlant(const SamplePlant&) = delete;
    SamplePlant& operator=(const SamplePlant&) = delete;
    ~SamplePlant() = default;

    image_writer::Source source(bool labels = true) const {
        return {.settings = settings,
                .configuration = configuration,
                .dictionary = dictionary,
                .configuration_id = configuration_id,
                .tool_version = {1, 2, 3},
                .labels = labels};
    }

    base::Bytes image(bool labels = true) const { return image_writer::write_image(source(labels)); }

    void set_reference(std::uint16_t number, double value) {
        parameter::Row& row = number == 980 ? oil_low : oil_high;
        row.number = number;
        parameter::Assignment assignment;
        assignment.row = &row;
        assignment.value = value;
        settings.governor.assign(assignment);
    }

    config::Pdo& tpdo(std::size_t number) { return configuration.pdos[number - 1]; }
    config::Pdo& rpdo(std::size_t number) { return configuration.pdos[15 + number]; }

    parameter::Row speed, position, load, temperature, oil, idle, enable, setpoint, pressure, oil_low,
        oil_high;
    parameter::Settings settings;
    config::Configuration configuration;
    dictionary::Dictionary dictionary;
    std::array<std::uint8_t, 32> configuration_id{};

  private:
    void rows() {
        speed = measurement(2000, "Speed", 16, false);
        speed.unit = "1/min";
        speed.scaling.emplace();
        speed.scaling->internal_maximum = 64000;
        speed.scaling->external_minimum = 0.0;
        speed.scaling->external_maximum = 4000.0;
        position = measurement(2300, "ActPos", 16, true);
        load = measurement(2101, "", 16, false);
        temperature = measurement(2201, "Temperature", 8, true);
        oil = measurement(2905, "OilPressure", 16, false);
        oil.unit = "bar";
        oil.scaling.emplace();
        oil.scaling->internal_maximum = 65535;
        oil.scaling->external_minimum_parameter = 980;
        oil.scaling->external_maximum_parameter = 981;
        idle = input_row(811, "FunctIdleSpeed", parameter::Role::switch_assignment);
        enable = input_row(835, "", parameter::Role::switch_assignment);
        setpoint = input_row(900, "AssignIn_Setp1Ext", parameter::Role::sensor_assignment);
        pressure = input_row(906, "AssignIn_AmbPress", parameter::Role::sensor_assignment);
    }

    void buses() {
        config::Configuration& c = configuration;
        c.governor_node = c.governor_node_in_gateway = 3;
        c.gateway_node = c.gateway_node_in_governor = 7;
        c.governor_start_up_delay_ms = 1000;
        c.gateway_start_up_delay_ms = 1500;
        c.governor_can.bit_rate_kbit = c.can1.bit_rate_kbit = 250;
        c.can2 = {.manual = true,
                  .prescaler = 3,
                  .sync_jump_width = 1,
                  .sampling_mode = 1,
                  .phase_segment_1 = 5,
                  .phase_segment_2 = 4,
                  .prop_segment = 2};
        c.node_id = 5;
        c.partner_node_id = 127;
        c.heartbeat_producer = {1010, 63, 63 * 16000};
        c.heartbeat_consumer = {100, 6, 6 * 16000};
        c.send_errors = true;
    }

    static config::MappedWord word(config::WordKind kind, std::uint16_t index, std::uint8_t sub,
                                   const parameter::Row* row = nullptr) {
        return {kind, index, sub, row};
    }

    void transmit() {
        using config::WordKind;
        for (std::size_t i = 0; i < 16; ++i) {
            config::Pdo& pdo = configuration.pdos[i];
            pdo.number = static_cast<std::uint8_t>(i + 1);
            const bool predefined = i < 4;
            pdo.cob_id = predefined ? static_cast<std::uint16_t>(0x185 + 0x100 * i) : std::uint16_t{0};
            pdo.cob_id_source = predefined ? config::CobIdSource::predefined : config::CobIdSource::parameter;
        }
        for (std::uint8_t sub = 1; sub <= 6; ++sub) {
            tpdo(sub <= 4 ? 1 : 2).mapping.push_back(word(WordKind::errors, 0x2000, sub));
        }
        tpdo(4).time = {16, 1, 15625};
        tpdo(4).mapping = {word(WordKind::measurement, 0x2001, 1, &speed),
                           word(WordKind::measurement, 0x2002, 1, &position),
                           word(WordKind::measurement, 0x2001, 2, &load),
                           word(WordKind::measurement, 0x2002, 2, &temperature)};
        tpdo(5).cob_id = 0x282;
        tpdo(5).time = {200, 12, 187500};
        tpdo(5).mapping = {word(WordKind::measurement, 0x2001, 3, &oil)};
        tpdo(6).cob_id = 0x682;  // inactive: kept
        tpdo(6).time = {10, 1, 15625};
        for (const std::size_t number : {1U, 2U, 4U, 5U}) {
            tpdo(number).active = true;
        }
    }

    void receive() {
        using config::WordKind;
        const config::MappedWord dummy = word(WordKind::dummy, config::dummy_index, 0);
        for (std::size_t number = 1; number <= 4; ++number) {
            rpdo(number).direction = config::Direction::receive;
            rpdo(number).number = static_cast<std::uint8_t>(number);
            rpdo(number).cob_id = static_cast<std::uint16_t>(0x105 + 0x100 * number);
            rpdo(number).active = number != 4;
        }
        rpdo(1).mapping = {word(WordKind::switches, 0x2003, 1), dummy,
                           word(WordKind::sensor_flags, 0x2003, 2)};
        rpdo(2).mapping = {word(WordKind::sensor, 0x2004, 1, &setpoint)};
        rpdo(2).time = {100, 6, 93750};
        rpdo(3).mapping = {dummy, dummy, word(WordKind::sensor, 0x2004, 7, &pressure)};
        configuration.switches = {{&idle, 1, false}, {&enable, 5, true}};
        configuration.sensors = {{&setpoint, 1}, {&pressure, 7}};
    }

    dictionary::Variable& add(std::uint16_t index, std::uint8_t sub, object::DataType type,
                              std::uint32_t value, object::Access access = object::Access::ro) {
        if (dictionary.objects.empty() || dictionary.objects.back().index != index) {
            dictionary.objects.emplace_back().index = index;
        }
        dictionary::Variable& variable = dictionary.objects.back().variables.emplace_back();
        variable.sub_index = sub;
        variable.type = type;
        variable.access = access;
        variable.default_value.number = value;
        return variable;
    }

    void words(std::uint16_t index, std::uint8_t count, object::DataType type,
               object::Access access = object::Access::ro) {
        add(index, 0, object::DataType::unsigned8, count);
        for (std::uint8_t sub = 1; sub <= count; ++sub) {
            add(index, sub, type, 0, access).pdo_mapping = true;
        }
    }

    void objects() {
        using object::DataType;
        add(0x1000, 0, DataType::unsigned32, 0x00020191);
        add(0x1001, 0, DataType::unsigned8, 0, object::Access::constant);
        add(0x1017, 0, DataType::unsigned16, 1008);
        add(0x1018, 0, DataType::unsigned8, 4);
        add(0x1018, 1, DataType::unsigned32, 0x161);
        add(0x1018, 2, DataType::unsigned32, 0x1B59);
        add(0x1018, 3, DataType::unsigned32, 12);
        add(0x1018, 4, DataType::unsigned32, 0x01970102);
        add(0x1800, 0, DataType::unsigned8, 5);
        add(0x1800, 1, DataType::unsigned32, 0x180).default_value.node_id_relative = true;
        add(0x1800, 2, DataType::unsigned8, 254);
        words(0x2000, 6, DataType::unsigned16);
        words(0x2001, 3, DataType::unsigned16);
        words(0x2002, 2, DataType::integer16);
        words(0x2003, 2, DataType::unsigned16, object::Access::rww);
        words(0x2004, 7, DataType::unsigned16, object::Access::rww);
        add(0x2005, 0, DataType::unsigned16, 0);
    }
};

}  // namespace cgw::test
