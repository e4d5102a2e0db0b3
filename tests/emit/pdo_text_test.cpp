// The PDO table for reading: text and Markdown.
#include <gtest/gtest.h>

#include <sstream>

#include "plant.hpp"

namespace cgw::emit {
namespace {

std::string table(const config::Configuration& configuration, const std::string& format,
                  const std::string& title = "Genset 2, starboard") {
    return test::SamplePlant(configuration, title).emit("pdo-table", format);
}

}  // namespace

TEST(PdoTableText, reads_as_a_table) {
    EXPECT_EQ(table(test::manual_configuration(), "text"), R"(PDO table: Genset 2, starboard
Configuration 0123456789abcdef, node 1

PDO    COB-ID  Bytes  Time              Word       Contents
TPDO1    181h      8  on change         1 2000h:1  Errors 0-15
                                        2 2000h:2  Errors 16-31
                                        3 2000h:3  Errors 32-47
                                        4 2000h:4  Errors 48-63
TPDO2    281h      4  on change         1 2000h:5  Errors 64-79
                                        2 2000h:6  Errors 80-95
TPDO3    381h      -  -                 inactive
TPDO4    481h      8  16 -> 15.625      1 2001h:1  2000 Speed
                                        2 2001h:2  2031 SpeedSetp
                                        3 2001h:3  2300 ActPos
                                        4 2001h:4  2330 ActPosSetpoint
TPDO5    282h      -  -                 inactive
TPDO6       -      -  200 -> 187.5      inactive
TPDO7       -      -  -                 inactive
TPDO8    382h      -  -                 inactive
TPDO9       -      -  -                 inactive
TPDO10      -      -  -                 inactive
TPDO11      -      -  -                 inactive
TPDO12   003h      -  -                 inactive
TPDO13      -      -  -                 inactive
TPDO14      -      -  -                 inactive
TPDO15      -      -  -                 inactive
TPDO16   57Fh      6  100 -> 93.75      1 2001h:5  2905 OilPressure
                                        2 2002h:1  2908 ChargeAirTemp
                                        3 2001h:6  2917 CurrentLoad
RPDO1    201h      6  not monitored     1 2003h:1  Switch Functions
                                          bit 1: 827 FunctSetpoint2Or1
                                          bit 5 low-active: 835 FunctLoadEnable
                                        2 0006h    dummy
                                        3 2003h:2  Sensor Error Flags
                                          bit 1: 900 AssignIn_Setp1Ext
                                          bit 2: 901 AssignIn_Setp2Ext
                                          bit 7: 906 AssignIn_AmbPress
                                          bit 12: 917 AssignIn_CurrentLoad
RPDO2    301h      4  100 -> 93.75      1 2004h:1  900 AssignIn_Setp1Ext
                                        2 2004h:2  901 AssignIn_Setp2Ext
RPDO3    401h      6  200 -> 187.5      1 0006h    dummy
                                        2 0006h    dummy
                                        3 2004h:7  906 AssignIn_AmbPress
RPDO4    501h      8  1000              1 0006h    dummy
                                        2 0006h    dummy
                                        3 0006h    dummy
                                        4 2004h:12 917 AssignIn_CurrentLoad

Times in ms: as set -> as the device runs them; for RPDOs the monitoring time
)");
}

TEST(PdoTableText, fits_80_columns) {
    std::istringstream lines(table(test::manual_configuration(), "text"));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 80U) << line;
        EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
}

TEST(PdoTableText, lists_the_other_sensors_of_a_shared_channel) {
    config::Configuration configuration = test::empty_configuration();
    configuration.sensors = {{&test::row::setpoint_1, 1}, {&test::row::unnamed_sensor, 1}};
    configuration.highest_channel = 1;
    test::set_receive_mapping(
        test::rpdo(configuration, 2),
        {{config::WordKind::sensor, config::object::sensors, 1, &test::row::setpoint_1}});
    EXPECT_NE(table(configuration, "text")
                  .find("1 2004h:1  900 AssignIn_Setp1Ext\n"
                        "                                          907\n"),
              std::string::npos)
        << table(configuration, "text");
}

TEST(PdoTableText, keeps_a_title_on_one_line) {
    EXPECT_EQ(table(test::empty_configuration(), "text", "a\nb\x1B[31m").rfind("PDO table: a b [31m\n", 0),
              0U);
    EXPECT_EQ(table(test::empty_configuration(), "text", "").rfind("PDO table\n", 0), 0U);
}

TEST(PdoTableMarkdown, reads_as_a_table) {
    const std::string text = table(test::manual_configuration(), "md");
    EXPECT_EQ(text.rfind("# PDO table: Genset 2, starboard\n"
                         "\n"
                         "Configuration `0123456789abcdef`, node 1\n"
                         "\n"
                         "| PDO | COB-ID | Bytes | Time | Word | Object | Contents |\n"
                         "|---|---:|---:|---|---:|---|---|\n"
                         "| TPDO1 | 181h | 8 | on change | 1 | 2000h:1 | Errors 0-15 |\n"
                         "| | | | | 2 | 2000h:2 | Errors 16-31 |\n",
                         0),
              0U)
        << text;
    for (const std::string line :
         {"| TPDO4 | 481h | 8 | 16 -> 15.625 | 1 | 2001h:1 | 2000 Speed |",
          "| TPDO6 | - | - | 200 -> 187.5 | | | inactive |", "| TPDO12 | 003h | - | - | | | inactive |",
          "| RPDO1 | 201h | 6 | not monitored | 1 | 2003h:1 | Switch Functions<br>bit 1: 827 "
          "FunctSetpoint2Or1<br>"
          "bit 5 low-active: 835 FunctLoadEnable |",
          "| | | | | 2 | 0006h | dummy |", "| | | | | 4 | 2004h:12 | 917 AssignIn\\_CurrentLoad |"}) {
        EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line << "\n" << text;
    }
}

TEST(PdoTableMarkdown, escapes_what_would_be_markup) {
    const std::string text = table(test::empty_configuration(), "md", "a|b *c* <d> `e` [f](g) \\ # &amp; ~");
    EXPECT_EQ(text.rfind("# PDO table: a\\|b \\*c\\* \\<d> \\`e\\` \\[f](g) \\\\ \\# \\&amp; \\~\n", 0), 0U)
        << text;
}

}  // namespace cgw::emit
