// What the CAN database says about a plant: names, scaling, bits, who sends and how often.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace cgw::emit {
namespace {

std::string dbc_of(const config::Configuration& configuration) {
    return test::SamplePlant(configuration).emit("dbc", "");
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// The lines of one message, up to the blank line behind it.
std::string message_of(const std::string& text, const std::string& name) {
    const std::size_t place = text.find(' ' + name + ": ");
    if (place == std::string::npos) {
        return "(missing)";
    }
    const std::size_t begin = text.rfind('\n', place) + 1;
    return text.substr(begin, text.find("\r\n\r\n", begin) - begin);
}

parameter::Row scaled(std::uint16_t number, std::string_view name, double low, double high,
                      std::int32_t internal_low = 0, std::int32_t internal_high = 65535) {
    parameter::Row row = test::make_row(number, name, internal_low < 0);
    row.scaling = parameter::Scaling{.internal_minimum = internal_low,
                                     .internal_maximum = internal_high,
                                     .external_minimum = low,
                                     .external_maximum = high};
    return row;
}

// TPDO4 with these rows.
std::string tpdo4_of(std::initializer_list<const parameter::Row*> rows) {
    config::Configuration configuration = test::empty_configuration();
    for (const parameter::Row* const row : rows) {
        test::add_output(configuration, 4, *row);
    }
    return dbc_of(configuration);
}

// RPDO1 word 1 with these switches.
std::string switches_of(std::vector<config::SwitchFunction> switches) {
    config::Configuration configuration = test::empty_configuration();
    configuration.switches = std::move(switches);
    test::set_receive_mapping(test::rpdo(configuration, 1),
                              {{config::WordKind::switches, config::object::binary_inputs, 1, nullptr}});
    return dbc_of(configuration);
}

config::Configuration with_sensor(const parameter::Row& row) {
    config::Configuration configuration = test::empty_configuration();
    configuration.sensors = {{&row, 1}};
    test::set_receive_mapping(test::rpdo(configuration, 2),
                              {{config::WordKind::sensor, config::object::sensors, 1, &row}});
    return configuration;
}

}  // namespace

TEST(EmitDbc, holds_active_pdos_only) {
    const std::string text = dbc_of(test::manual_configuration());
    for (const std::string name : {"TPDO1", "TPDO2", "TPDO4", "TPDO16", "RPDO1", "RPDO2", "RPDO3", "RPDO4"}) {
        EXPECT_NE(message_of(text, "GW1_" + name), "(missing)") << name;
    }
    for (const std::string name : {"TPDO3", "TPDO5", "TPDO6", "TPDO8"}) {
        EXPECT_EQ(message_of(text, "GW1_" + name), "(missing)") << name;
    }
}

TEST(EmitDbc, names_gateway_and_partner) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_TRUE(contains(text, "\r\nBU_: GW1 Node127\r\n"));
    EXPECT_TRUE(contains(text, "BO_ 385 GW1_TPDO1: 8 GW1\r\n"));
    EXPECT_TRUE(contains(text, "BO_ 513 GW1_RPDO1: 6 Node127\r\n"));
    EXPECT_TRUE(contains(text, "BO_ 1919 Node127_Heartbeat: 1 Node127\r\n"));
}

TEST(EmitDbc, knows_a_master_where_there_is_no_partner) {
    const std::string text = dbc_of(test::empty_configuration());
    EXPECT_TRUE(contains(text, "\r\nBU_: GW1 Master\r\n"));
    EXPECT_EQ(message_of(text, "NMT"),
              "BO_ 0 NMT: 2 Master\r\n"
              " SG_ Command : 0|8@1+ (1,0) [0|255] \"\" GW1\r\n"
              " SG_ NodeID : 8|8@1+ (1,0) [0|255] \"\" GW1");
    EXPECT_EQ(message_of(text, "Master_Heartbeat"), "(missing)");
    EXPECT_TRUE(contains(text, "CM_ BO_ 1793 \"boot-up only, no heartbeat is set\";"));
}

TEST(EmitDbc, carries_title_configuration_and_version) {
    const std::string text = dbc_of(test::empty_configuration());
    EXPECT_TRUE(contains(text, "VERSION \"cgw 0.1.0, configuration 0123456789abcdef\"\r\n"));
    EXPECT_TRUE(contains(text, "CM_ \"Genset 2, starboard. Gateway node 1, configuration 0123456789abcdef."));
}

TEST(EmitDbc, scales_by_the_external_limits) {
    parameter::Row speed = scaled(2000, "Speed", 0, 131070);
    speed.unit = "1/min";
    parameter::Row temperature = scaled(2907, "CoolantTemp", -100, 27.5, 0, 255);
    temperature.unit = "°C";
    const parameter::Row balance = scaled(2001, "Balance", -50, 50, -100, 100);
    const std::string text = tpdo4_of({&speed, &temperature, &balance});
    EXPECT_EQ(message_of(text, "GW1_TPDO4"),
              "BO_ 1153 GW1_TPDO4: 6 GW1\r\n"
              " SG_ Speed : 0|16@1+ (2,0) [0|131070] \"1/min\" Master\r\n"
              " SG_ CoolantTemp : 16|16@1+ (0.5,-100) [-100|27.5] \"degC\" Master\r\n"
              " SG_ Balance : 32|16@1- (0.5,0) [-50|50] \"\" Master");
    EXPECT_TRUE(contains(text, "CM_ SG_ 1153 CoolantTemp \"2907 CoolantTemp, 2001h:2\";"));
}

TEST(EmitDbc, spells_units_or_leaves_them_out_with_a_word) {
    parameter::Row load = scaled(2001, "Load", 0, 65535);
    load.unit = "‰ m²";
    parameter::Row odd = scaled(2002, "Odd", 0, 65535);
    odd.unit = "船/h";
    const std::string text = tpdo4_of({&load, &odd});
    EXPECT_TRUE(contains(text, " SG_ Load : 0|16@1+ (1,0) [0|65535] \"permille m2\" Master"));
    EXPECT_TRUE(contains(text, " SG_ Odd : 16|16@1+ (1,0) [0|65535] \"\" Master"));
    EXPECT_TRUE(contains(text,
                         "CM_ SG_ 1153 Odd \"2002 Odd, 2001h:2; scaled, but its unit has no spelling in "
                         "ASCII and is left out\";"));
}

TEST(EmitDbc, keeps_a_falling_line_and_states_its_range_in_order) {
    const parameter::Row row = scaled(2001, "Gap", 65535, 0);
    EXPECT_TRUE(contains(tpdo4_of({&row}), " SG_ Gap : 0|16@1+ (-1,65535) [0|65535] \"\" Master"));
}

TEST(EmitDbc, takes_the_limits_from_reference_parameters) {
    parameter::Row oil = test::make_row(2905, "OilPressure");
    oil.unit = "bar";
    oil.scaling = parameter::Scaling{
        .internal_maximum = 65535, .external_minimum_parameter = 980, .external_maximum_parameter = 981};
    config::Configuration configuration = test::empty_configuration();
    test::add_output(configuration, 4, oil);
    test::SamplePlant plant(configuration);
    EXPECT_TRUE(contains(plant.emit("dbc", ""), " SG_ OilPressure : 0|16@1+ (1,0) [0|65535] \"\" Master"));
    const parameter::Row low = test::make_row(980, "OilPressSensorLow");
    const parameter::Row high = test::make_row(981, "OilPressSensorHigh");
    plant.settings.governor.assign({.row = &low, .value = 0});
    plant.settings.governor.assign({.row = &high, .value = 65535 * 2});
    EXPECT_TRUE(
        contains(plant.emit("dbc", ""), " SG_ OilPressure : 0|16@1+ (2,0) [0|131070] \"bar\" Master"));
}

TEST(EmitDbc, gives_the_raw_number_where_the_scaling_is_not_known) {
    parameter::Row plain = test::make_row(2330, "ActPosSetpoint");
    plain.unit = "%";  // of a number that is no percentage
    parameter::Row byte = test::make_row(2101, "Byte");
    byte.width = 8;
    parameter::Row signed_byte = test::make_row(2102, "SignedByte", true);
    signed_byte.width = 8;
    const parameter::Row signed_word = test::make_row(2103, "SignedWord", true);
    const std::string text = tpdo4_of({&plain, &byte, &signed_byte, &signed_word});
    EXPECT_EQ(message_of(text, "GW1_TPDO4"),
              "BO_ 1153 GW1_TPDO4: 8 GW1\r\n"
              " SG_ ActPosSetpoint : 0|16@1+ (1,0) [0|65535] \"\" Master\r\n"
              " SG_ Byte : 16|16@1+ (1,0) [0|255] \"\" Master\r\n"
              " SG_ SignedByte : 32|16@1- (1,0) [-128|127] \"\" Master\r\n"
              " SG_ SignedWord : 48|16@1- (1,0) [-32768|32767] \"\" Master");
    EXPECT_TRUE(contains(text, "\"2330 ActPosSetpoint, 2001h:1; raw number, its scaling is not known\""));
}

TEST(EmitDbc, keeps_names_apart_that_collapse) {
    const parameter::Row one = test::make_row(2001, "Oil-Press");
    const parameter::Row two = test::make_row(2002, "Oil Press");
    const parameter::Row three = test::make_row(2003, "OIL_PRESS");
    const std::string text = tpdo4_of({&one, &two, &three, &one});
    for (const std::string name : {"Oil_Press ", "Oil_Press_2 ", "OIL_PRESS_3 ", "Oil_Press_4 "}) {
        EXPECT_TRUE(contains(text, " SG_ " + name)) << name;
    }
    EXPECT_TRUE(contains(text, "CM_ SG_ 1153 Oil_Press_2 \"2002 Oil Press, 2001h:2; raw number"));
}

TEST(EmitDbc, cuts_long_names_and_keeps_them_whole_in_the_comment) {
    const std::string long_name = "MeanExhaustTemperatureBehindTheTurbine";
    const parameter::Row left = test::make_row(2001, long_name);
    const parameter::Row right = test::make_row(2002, long_name);
    const std::string text = tpdo4_of({&left, &right});
    EXPECT_TRUE(contains(text, " SG_ MeanExhaustTemperatureBehindTheT : "));
    EXPECT_TRUE(contains(text, " SG_ MeanExhaustTemperatureBehindTh_2 : "));
    EXPECT_TRUE(contains(text, "\"2002 " + long_name + ", 2001h:2"));
}

TEST(EmitDbc, numbers_what_has_no_name) {
    const parameter::Row nameless = test::make_row(2999, "");
    EXPECT_TRUE(contains(tpdo4_of({&nameless}), " SG_ Parameter_2999 : "));
    const parameter::Row nameless_switch = test::make_row(812, "");
    EXPECT_TRUE(contains(switches_of({{&nameless_switch, 3, false}}), " SG_ Switch_812 : 2|1@1+ "));
    EXPECT_TRUE(contains(dbc_of(with_sensor(test::row::unnamed_sensor)), " SG_ Sensor_907 : "));
}

TEST(EmitDbc, gives_every_error_bit_a_signal) {
    test::SamplePlant plant(test::manual_configuration());
    parameter::Row row = test::make_row(3070, "ErrCanBus");
    plant.catalogue.put(row);
    row = test::make_row(3070, "ErrCanBus1");
    row.device = parameter::Device::gateway;
    plant.catalogue.put(row);
    row = test::make_row(3085, "ErrVoltage");
    row.device = parameter::Device::gateway;
    plant.catalogue.put(row);
    const std::string text = plant.emit("dbc", "");
    EXPECT_TRUE(contains(text, " SG_ Error_3000 : 0|1@1+ (1,0) [0|1] \"\" Node127"));
    EXPECT_TRUE(contains(text, " SG_ Error_3063 : 63|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ Error_3064 : 0|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ ErrCanBus : 6|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ ErrVoltage : 21|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ Error_3095 : 31|1@1+ "));
    EXPECT_TRUE(contains(text,
                         "CM_ SG_ 641 ErrCanBus \"3070, 2000h:5; governor ErrCanBus; gateway ErrCanBus1; 1: "
                         "the error is present\";"));
}

TEST(EmitDbc, has_the_eight_engine_state_bits) {
    config::Configuration configuration = test::empty_configuration();
    test::tpdo(configuration, 3).active = true;
    test::tpdo(configuration, 3).mapping = {
        {config::WordKind::engine_state, config::object::errors, 7, nullptr}};
    const std::string text = dbc_of(configuration);
    EXPECT_TRUE(contains(text, "BO_ 897 GW1_TPDO3: 2 GW1\r\n SG_ EngineState_Bit1 : 0|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ EngineState_Bit8 : 7|1@1+ "));
    EXPECT_FALSE(contains(text, "EngineState_Bit9"));
}

TEST(EmitDbc, says_what_a_switch_bit_means) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_TRUE(contains(text, " SG_ FunctSetpoint2Or1 : 0|1@1+ (1,0) [0|1] \"\" GW1"));
    EXPECT_TRUE(contains(text, " SG_ FunctLoadEnable : 4|1@1+ (1,0) [0|1] \"\" GW1"));
    EXPECT_TRUE(contains(
        text, "CM_ SG_ 513 FunctLoadEnable \"2003h:1 bit 5; 835 FunctLoadEnable, low-active: 0 is on\";"));
    EXPECT_TRUE(contains(text, "VAL_ 513 FunctSetpoint2Or1 0 \"off\" 1 \"on\" ;"));
    EXPECT_TRUE(contains(text, "VAL_ 513 FunctLoadEnable 0 \"on\" 1 \"off\" ;"));
}

TEST(EmitDbc, makes_one_signal_of_a_shared_switch_bit) {
    const parameter::Row first = test::make_row(811, "FunctIdleSpeed");
    const std::string text = switches_of({{&first, 1, false}, {&test::row::setpoint_switch, 1, true}});
    EXPECT_TRUE(contains(text, " SG_ FunctIdleSpeed : 0|1@1+ "));
    EXPECT_FALSE(contains(text, " SG_ FunctSetpoint2Or1"));
    EXPECT_TRUE(contains(text,
                         "\"2003h:1 bit 1; 811 FunctIdleSpeed, high-active: 1 is on; 827 FunctSetpoint2Or1, "
                         "low-active: 0 is on\""));
    EXPECT_FALSE(contains(text, "VAL_ 513 FunctIdleSpeed"));  // the two disagree
    EXPECT_TRUE(contains(switches_of({{&first, 1, true}, {&test::row::setpoint_switch, 1, true}}),
                         "VAL_ 513 FunctIdleSpeed 0 \"on\" 1 \"off\" ;"));
}

TEST(EmitDbc, names_sensor_flags_after_their_sensor) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_TRUE(contains(text, " SG_ AssignIn_Setp1Ext_Error : 32|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ AssignIn_AmbPress_Error : 38|1@1+ "));
    EXPECT_TRUE(contains(text, " SG_ AssignIn_CurrentLoad_Error : 43|1@1+ "));
    EXPECT_TRUE(
        contains(text, "\"2003h:2 bit 7, error flag of channel 7: 906 AssignIn_AmbPress; 1: faulty\""));
}

TEST(EmitDbc, leaves_dummies_out) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_EQ(message_of(text, "GW1_RPDO4"),
              "BO_ 1281 GW1_RPDO4: 8 Node127\r\n"
              " SG_ AssignIn_CurrentLoad : 48|16@1+ (1,0) [0|65535] \"\" GW1");
}

TEST(EmitDbc, scales_a_sensor_as_the_measurement_that_shows_it) {
    test::SamplePlant plant(with_sensor(test::row::ambient_pressure));
    parameter::Row shown = scaled(2906, "AmbientPressure", 500, 500 + 65535);
    shown.unit = "mbar";
    plant.catalogue.put(shown);
    const std::string text = plant.emit("dbc", "");
    EXPECT_TRUE(contains(text, " SG_ AssignIn_AmbPress : 0|16@1+ (1,500) [500|66035] \"mbar\" GW1"));
    EXPECT_TRUE(
        contains(text, "\"channel 1, 2004h:1: 906 AssignIn_AmbPress; shown by 2906 AmbientPressure\""));
}

TEST(EmitDbc, prefers_a_sensors_own_scaling) {
    const parameter::Row own = scaled(906, "AssignIn_AmbPress", 0, 65535 * 2);
    test::SamplePlant plant(with_sensor(own));
    plant.catalogue.put(scaled(2906, "AmbientPressure", 0, 65535));
    EXPECT_TRUE(
        contains(plant.emit("dbc", ""), " SG_ AssignIn_AmbPress : 0|16@1+ (2,0) [0|131070] \"\" GW1"));
}

TEST(EmitDbc, says_how_often_messages_come) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_TRUE(contains(text, "CM_ BO_ 1153 \"TPDO4 (1803h, 1A03h), sent every 15.625 ms\";"));
    EXPECT_TRUE(contains(text, "BA_ \"GenMsgCycleTime\" BO_ 1153 15;"));
    EXPECT_TRUE(contains(text, "BA_ \"GenMsgSendType\" BO_ 1153 0;"));
    EXPECT_TRUE(contains(text, "CM_ BO_ 385 \"TPDO1 (1800h, 1A00h), sent when a bit changes\";"));
    EXPECT_TRUE(contains(text, "BA_ \"GenMsgSendType\" BO_ 385 1;"));
    EXPECT_TRUE(contains(text, "CM_ BO_ 513 \"RPDO1 (1400h, 1600h), not monitored\";"));
    EXPECT_TRUE(
        contains(text, "CM_ BO_ 769 \"RPDO2 (1401h, 1601h), monitored: comes at least every 93.75 ms\";"));
    EXPECT_FALSE(contains(text, "\"GenMsgCycleTime\" BO_ 769"));
    EXPECT_TRUE(contains(text, "BA_ \"GenMsgCycleTime\" BO_ 1793 992;"));
}

TEST(EmitDbc, has_the_services_with_their_values) {
    const std::string text = dbc_of(test::manual_configuration());
    EXPECT_TRUE(contains(text, "BO_ 1537 GW1_SDO_Request: 8 Node127\r\n"));
    EXPECT_TRUE(contains(text, "BO_ 1409 GW1_SDO_Answer: 8 GW1\r\n"));
    EXPECT_TRUE(contains(
        text, "VAL_ 1793 State 0 \"boot-up\" 4 \"Stopped\" 5 \"Operational\" 127 \"Pre-Operational\" ;"));
    EXPECT_TRUE(contains(text, "VAL_ 0 Command 1 \"start\" 2 \"stop\" 128 "));
}

}  // namespace cgw::emit
