// The PDO table as JSON (an outside contract: exact) and CSV.
#include <gtest/gtest.h>

#include <sstream>

#include "plant.hpp"

namespace cgw::emit {
namespace {

std::string json_of(const config::Configuration& configuration) {
    return test::SamplePlant(configuration).emit("pdo-table", "json");
}

// The JSON object of one PDO, to the beginning of the next.
std::string pdo_of(const std::string& json, const std::string& name) {
    const std::size_t begin = json.find("{\"name\":\"" + name + "\",\"direction\"");
    if (begin == std::string::npos) {
        return "(missing)";
    }
    const std::size_t end = json.find(",{\"name\":\"", json.find("\"mapping\":[", begin) + 1);
    const std::size_t next = json.find("\"direction\"", begin + 40);
    const std::size_t stop = next == std::string::npos ? json.rfind("]}") : json.rfind(",{\"name\"", next);
    return json.substr(begin, (end == std::string::npos ? stop : std::max(end, stop)) - begin);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::string csv_of(const config::Configuration& configuration, const std::string& title) {
    return test::SamplePlant(configuration, title).emit("pdo-table", "csv");
}

}  // namespace

TEST(PdoTableJson, begins_with_version_node_and_configuration) {
    const std::string json = json_of(test::empty_configuration());
    EXPECT_EQ(
        json.rfind("{\"format_version\":1,\"node_id\":1,\"configuration_id\":\"0123456789abcdef\",\"pdos\":["
                   "{\"name\":\"TPDO1\",",
                   0),
        0U);
    EXPECT_EQ(json.substr(json.size() - 4), "}]}\n");
}

TEST(PdoTableJson, holds_all_20_pdos_in_order) {
    const std::string json = json_of(test::empty_configuration());
    std::size_t place = 0;
    for (int i = 1; i <= 20; ++i) {
        const std::string name = i <= 16 ? "TPDO" + std::to_string(i) : "RPDO" + std::to_string(i - 16);
        const std::size_t found = json.find("{\"name\":\"" + name + "\",");
        ASSERT_NE(found, std::string::npos) << name;
        EXPECT_GT(found, place);
        place = found;
    }
}

TEST(PdoTableJson, shows_an_analogue_tpdo_with_its_parameters) {
    EXPECT_EQ(pdo_of(json_of(test::manual_configuration()), "TPDO4"),
              R"({"name":"TPDO4","direction":"transmit","number":4,"active":true,"cob_id":1153,)"
              R"("cob_id_source":"predefined","length":8,"transmission_type":254,"time_ms":16,)"
              R"("effective_time_us":15625,"mapping":[)"
              R"({"index":8193,"sub_index":1,"bits":16,"parameter":2000,"name":"Speed"},)"
              R"({"index":8193,"sub_index":2,"bits":16,"parameter":2031,"name":"SpeedSetp"},)"
              R"({"index":8193,"sub_index":3,"bits":16,"parameter":2300,"name":"ActPos"},)"
              R"({"index":8193,"sub_index":4,"bits":16,"parameter":2330,"name":"ActPosSetpoint"}]})");
}

TEST(PdoTableJson, shows_binary_tpdos_without_parameter_and_time) {
    EXPECT_EQ(pdo_of(json_of(test::manual_configuration()), "TPDO2"),
              R"({"name":"TPDO2","direction":"transmit","number":2,"active":true,"cob_id":641,)"
              R"("cob_id_source":"predefined","length":4,"transmission_type":254,"time_ms":0,)"
              R"("effective_time_us":0,"mapping":[)"
              R"({"index":8192,"sub_index":5,"bits":16,"parameter":null,"name":"Errors 64-79"},)"
              R"({"index":8192,"sub_index":6,"bits":16,"parameter":null,"name":"Errors 80-95"}]})");
}

TEST(PdoTableJson, keeps_identifier_and_time_of_inactive_pdos) {
    const std::string json = json_of(test::manual_configuration());
    EXPECT_EQ(pdo_of(json, "TPDO6"),
              R"({"name":"TPDO6","direction":"transmit","number":6,"active":false,"cob_id":0,)"
              R"("cob_id_source":"parameter","length":0,"transmission_type":254,"time_ms":200,)"
              R"("effective_time_us":187500,"mapping":[]})");
    EXPECT_EQ(pdo_of(json, "TPDO8"),
              R"({"name":"TPDO8","direction":"transmit","number":8,"active":false,"cob_id":898,)"
              R"("cob_id_source":"parameter","length":0,"transmission_type":254,"time_ms":0,)"
              R"("effective_time_us":0,"mapping":[]})");
}

TEST(PdoTableJson, says_which_switches_and_sensor_flags_rpdo1_carries) {
    EXPECT_EQ(
        pdo_of(json_of(test::manual_configuration()), "RPDO1"),
        R"({"name":"RPDO1","direction":"receive","number":1,"active":true,"cob_id":513,)"
        R"("cob_id_source":"predefined","length":6,"transmission_type":254,"time_ms":0,)"
        R"("effective_time_us":0,"mapping":[)"
        R"({"index":8195,"sub_index":1,"bits":16,"parameter":null,"name":"Switch Functions","switches":[)"
        R"({"bit":1,"parameter":827,"low_active":false},{"bit":5,"parameter":835,"low_active":true}]},)"
        R"({"index":6,"sub_index":0,"bits":16,"parameter":null,"name":"dummy"},)"
        R"({"index":8195,"sub_index":2,"bits":16,"parameter":null,"name":"Sensor Error Flags","sensors":[)"
        R"({"bit":1,"parameter":900},{"bit":2,"parameter":901},{"bit":7,"parameter":906},)"
        R"({"bit":12,"parameter":917}]}]})");
}

TEST(PdoTableJson, says_which_sensor_a_channel_carries) {
    const std::string json = json_of(test::manual_configuration());
    EXPECT_EQ(pdo_of(json, "RPDO3"),
              R"({"name":"RPDO3","direction":"receive","number":3,"active":true,"cob_id":1025,)"
              R"("cob_id_source":"predefined","length":6,"transmission_type":254,"time_ms":200,)"
              R"("effective_time_us":187500,"mapping":[)"
              R"({"index":6,"sub_index":0,"bits":16,"parameter":null,"name":"dummy"},)"
              R"({"index":6,"sub_index":0,"bits":16,"parameter":null,"name":"dummy"},)"
              R"({"index":8196,"sub_index":7,"bits":16,"parameter":906,"name":"AssignIn_AmbPress",)"
              R"("sensors":[{"channel":7,"parameter":906}]}]})");
}

TEST(PdoTableJson, lists_all_sensors_of_a_shared_channel_by_number) {
    config::Configuration configuration = test::manual_configuration();
    configuration.sensors = {
        {&test::row::setpoint_1, 2}, {&test::row::setpoint_2, 1}, {&test::row::unnamed_sensor, 2}};
    configuration.highest_channel = 2;
    test::rpdo(configuration, 2).mapping = {
        {config::WordKind::sensor, config::object::sensors, 1, &test::row::setpoint_2},
        {config::WordKind::sensor, config::object::sensors, 2, &test::row::setpoint_1}};
    const std::string json = json_of(configuration);
    EXPECT_NE(json.find(R"("sensors":[{"channel":2,"parameter":900},{"channel":2,"parameter":907}])"),
              std::string::npos);
    EXPECT_NE(
        json.find(
            R"("sensors":[{"bit":1,"parameter":901},{"bit":2,"parameter":900},{"bit":2,"parameter":907}])"),
        std::string::npos);
}

TEST(PdoTableJson, names_a_sensor_without_name_by_its_object) {
    config::Configuration configuration = test::empty_configuration();
    configuration.sensors = {{&test::row::unnamed_sensor, 1}};
    configuration.highest_channel = 1;
    test::set_receive_mapping(
        test::rpdo(configuration, 2),
        {{config::WordKind::sensor, config::object::sensors, 1, &test::row::unnamed_sensor}});
    EXPECT_NE(json_of(configuration).find(R"("parameter":907,"name":"Sensor 907","sensors":)"),
              std::string::npos);
}

TEST(PdoTableCsv, has_one_line_per_mapped_word) {
    const std::vector<std::string> lines = lines_of(csv_of(test::manual_configuration(), "Genset"));
    ASSERT_EQ(lines.size(), 1U + 4 + 2 + 4 + 3 + 3 + 2 + 3 + 4);
    EXPECT_EQ(
        lines[0],
        "pdo,direction,cob_id,cob_id_source,length,transmission_type,time_ms,effective_time_us,word,index,"
        "sub_index,bits,parameter,name,carries,node_id,configuration_id,title");
    EXPECT_EQ(
        lines[1],
        "TPDO1,transmit,0x181,predefined,8,254,0,0,1,0x2000,1,16,,Errors 0-15,,1,0123456789abcdef,Genset");
    EXPECT_EQ(
        lines[8],
        "TPDO4,transmit,0x481,predefined,8,254,16,15625,2,0x2001,2,16,2031,SpeedSetp,,1,0123456789abcdef,"
        "Genset");
    EXPECT_EQ(
        lines[14],
        "RPDO1,receive,0x201,predefined,6,254,0,0,1,0x2003,1,16,,Switch Functions,"
        "bit 1: 827 FunctSetpoint2Or1; bit 5 low-active: 835 FunctLoadEnable,1,0123456789abcdef,Genset");
    EXPECT_EQ(lines[17],
              "RPDO2,receive,0x301,predefined,4,254,100,93750,1,0x2004,1,16,900,AssignIn_Setp1Ext,"
              "900 AssignIn_Setp1Ext,1,0123456789abcdef,Genset");
}

TEST(PdoTableCsv, ends_lines_with_line_feeds_only) {
    const std::string csv = csv_of(test::manual_configuration(), "Genset");
    EXPECT_EQ(csv.find('\r'), std::string::npos);
    EXPECT_EQ(csv.back(), '\n');
}

TEST(PdoTableCsv, quotes_separators_and_quotes) {
    EXPECT_NE(
        csv_of(test::manual_configuration(), "Genset 2, \"port\"").find(",\"Genset 2, \"\"port\"\"\"\n"),
        std::string::npos);
    EXPECT_NE(csv_of(test::manual_configuration(), "two\nlines").find(",\"two\nlines\"\n"),
              std::string::npos);
}

TEST(PdoTableCsv, disarms_what_a_spreadsheet_would_run) {
    for (const std::string title : {"=1+1", "+A1", "-A1", "@SUM", "\tx"}) {
        EXPECT_NE(csv_of(test::manual_configuration(), title).find(",'" + title + "\n"), std::string::npos)
            << title;
    }
    EXPECT_NE(csv_of(test::manual_configuration(), "=A,B").find(",\"'=A,B\"\n"), std::string::npos);
    EXPECT_NE(csv_of(test::manual_configuration(), "\rx").find(",\"'\rx\"\n"), std::string::npos);
    EXPECT_NE(csv_of(test::manual_configuration(), "1=1").find(",1=1\n"), std::string::npos);
    EXPECT_NE(csv_of(test::manual_configuration(), "-1").find(",-1\n"), std::string::npos);  // a number
}

TEST(PdoTableCsv, is_only_a_heading_when_nothing_is_active) {
    EXPECT_EQ(lines_of(csv_of(test::empty_configuration(), "")).size(), 1U);
}

}  // namespace cgw::emit
