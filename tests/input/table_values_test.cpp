// Printed tables: numbers, number bases and units.
#include "input/printed_table.hpp"

namespace cgw::input {
namespace {

TEST(ParameterTable, reads_hexadecimal_by_unit_suffix_or_prefix) {
    const auto value = [](std::string_view cells) {
        return values_in(fmt::format("16404;CanOpTPDO5-16ID(0);{}\n", cells), Device::gateway);
    };
    EXPECT_EQ(value("282;Hex"), "16404=0x282");
    EXPECT_EQ(value("282 hex"), "16404=0x282");
    EXPECT_EQ(value("282h"), "16404=0x282");
    EXPECT_EQ(value("0x57f"), "16404=0x57f");
    EXPECT_EQ(value("57F"), "16404=0x57F");
    EXPECT_EQ(value("3"), "16404=3");
}

TEST(ParameterTable, refuses_hexadecimal_for_a_parameter_with_a_unit) {
    const auto found = [](std::string_view cells) {
        return findings_in(fmt::format("429;CanOpHeartBeatTxTime;{}\n", cells), Device::gateway);
    };
    const std::string message = "429 CanOpHeartBeatTxTime is in ms, and the table says ";
    EXPECT_EQ(found("1000;Hex"), "E0504 1:26 " + message + "hexadecimal digits\n");
    EXPECT_EQ(found("1000 hex"), "E0504 1:26 " + message + "hexadecimal digits\n");
    EXPECT_EQ(found("3E8h"), "E0504 1:26 " + message + "hexadecimal digits\n");
    EXPECT_EQ(found("0x3E8;"), "E0504 1:26 " + message + "hexadecimal digits\n");
    EXPECT_EQ(found("1000;dec"), "E0504 1:26 " + message + "`dec`\n");
    EXPECT_EQ(findings_in("429 CanOpHeartBeatTxTime 1000 Hex\n", Device::gateway),
              "E0504 1:26 " + message + "hexadecimal digits\n");
    EXPECT_EQ(found("1000;ms"), "");
}

TEST(ParameterTable, refuses_hexadecimal_for_a_parameter_shown_in_decimal) {
    const Read result = read("427;CanOpenMyNodeID;12;Hex\n", Device::gateway);
    EXPECT_EQ(text_of(result.findings),
              "E0502 1:21 427 CanOpenMyNodeID is 12, which is hexadecimal where DcDesk shows decimal\n");
    EXPECT_EQ(result.findings.all()[0].help, "write 18 or 12");
    EXPECT_EQ(values_in("427;CanOpenMyNodeID;9;Hex\n428;;12;dec\n", Device::gateway), "427=0x9 428=12");
}

TEST(ParameterTable, refuses_a_unit_that_contradicts_the_digits) {
    const auto found = [](std::string_view cells) {
        return read(fmt::format("16404;CanOpTPDO5-16ID(0);{}\n", cells), Device::gateway).findings;
    };
    EXPECT_EQ(text_of(found("0x282;dec")),
              "E0502 1:26 16404 CanOpTPDO5-16ID(0) is 0x282, and the unit says dec\n");
    EXPECT_EQ(
        text_of(found("642;Dez")),
        "E0502 1:26 16404 CanOpTPDO5-16ID(0) is 642, and decimal says the unit where DcDesk shows Hex\n");
    EXPECT_EQ(found("642;Dez").all()[0].help, "write 282 Hex");
    EXPECT_EQ(text_of(found("3;Dez")), "");
}

TEST(ParameterTable, refuses_decimal_digits_of_a_hexadecimal_parameter) {
    const Read result = read("16404;CanOpTPDO5-16ID(0);282\n", Device::gateway);
    EXPECT_EQ(text_of(result.findings),
              "E0502 1:26 16404 CanOpTPDO5-16ID(0) is 282, which is 282h or 11Ah\n");
    EXPECT_EQ(result.findings.all()[0].help, "write 282 Hex in the table, or 11A Hex");
}

TEST(ParameterTable, refuses_what_may_be_thousands) {
    const Read result = read("16480;CanOpRPDO1-4Cyc(0);1.000;ms\n");
    EXPECT_EQ(text_of(result.findings),
              "E0502 1:26 16480 CanOpRPDO1-4Cyc(0) is 1.000, which is 1000 or 1 and a fraction\n");
    EXPECT_EQ(result.findings.all()[0].help, "write 1000, or 1.0000");
    EXPECT_EQ(findings_in("992;MeasPowerSensorLow;1,250;kW\n"),
              "E0502 1:24 992 MeasPowerSensorLow is 1,250, which is 1250 or 1 and a fraction\n");
    EXPECT_EQ(findings_in("992;MeasPowerSensorLow;1.250,5;kW\n"),
              "E0502 1:24 992 MeasPowerSensorLow is 1.250,5, with more than one separator\n");
    EXPECT_EQ(findings_in("16480 CanOpRPDO1-4Cyc(0) 1 000 ms\n"),
              "E0502 1:26 16480 CanOpRPDO1-4Cyc(0) is 1, and another number, 000, follows\n");
    EXPECT_EQ(findings_in("16400 CanOpTPDO4Assign(0) 2 000\n"),
              "E0502 1:27 16400 CanOpTPDO4Assign(0) is 2, and another number, 000, follows\n");
}

TEST(ParameterTable, keeps_the_digits_of_a_fraction) {
    EXPECT_EQ(values_in("400;;0,125;s\n978;;1,50;bar\n979;;04.5;bar\n992;;1250,0;kW\n"),
              "400=0.125 978=1.50 979=4.5 992=1250.0");
}

TEST(ParameterTable, compares_units_and_converts_none) {
    EXPECT_EQ(values_in("416;;250;kBits/s\n16480;;100;[MS]\n400;;1;-\n401;;1;any\n"),
              "400=1 401=1 416=250 16480=100");
    const Read result = read("16480;CanOpRPDO1-4Cyc(0);1;s\n");
    EXPECT_EQ(text_of(result.findings),
              "E0504 1:26 16480 CanOpRPDO1-4Cyc(0) is in ms, and the table says `s`\n");
}

TEST(ParameterTable, holds_values_to_their_range) {
    EXPECT_EQ(findings_in("416;CanBaudrate;200;\n"),
              "E0111 1:17 416 CanBaudrate is 200, none of 125, 250, 500 or 1000 kbit/s\n");
    EXPECT_EQ(findings_in("16404;;57FF;Hex\n", Device::gateway),
              "E0111 1:8 16404 CanOpTPDO5-16ID(0) is 57FF, outside 0..0x7FF\n");
}

}  // namespace
}  // namespace cgw::input
