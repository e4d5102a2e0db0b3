// Printed parameter tables: the manual's own, and every slip a table can have.
#include "input/parameter_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "catalogue/catalogue.hpp"
#include "support/golden.hpp"

namespace cgw::input {
namespace {

using parameter::Device;

struct Read {
    PrintedTable table;
    diagnostic::Findings findings;
};

Read read(std::string_view text, Device device = Device::governor) {
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    Read result;
    result.table = read_parameter_table(text, "t", device, catalogue, result.findings);
    result.findings.sort();
    return result;
}

// "E0501 2:3 message\n"
std::string text_of(const diagnostic::Findings& findings) {
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        text += fmt::format("{} {}:{} {}\n", finding.rule->code, finding.where.range.start.line,
                            finding.where.range.start.column, finding.message);
    }
    return text;
}

std::string findings_in(std::string_view text, Device device = Device::governor) {
    return text_of(read(text, device).findings);
}

// "401=1 16404=0x282"
std::string values_of(const PrintedTable& table) {
    std::string text;
    for (const auto& [number, value] : table.values) {
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", number, value.literal);
    }
    return text;
}

std::string values_in(std::string_view text, Device device = Device::governor) {
    const Read result = read(text, device);
    EXPECT_EQ(text_of(result.findings), "") << text;
    return values_of(result.table);
}

std::string without_dots(const std::string& table) {
    std::string text;
    for (std::size_t at = 0; at < table.size();) {
        const std::size_t end = table.find('\n', at) + 1;
        const std::string line = table.substr(at, end - at);
        text += line.find(':') == std::string::npos || line.find_first_of("1A-") < 2 ? line : "";
        at = end;
    }
    return text;
}

class ManualTables : public testing::TestWithParam<const char*> {
  protected:
    static std::string table(const std::string& device) {
        return test::read_text(std::filesystem::path(CGW_TEST_DATA) / "tables" /
                               fmt::format("manual-{}.{}", device, GetParam()));
    }
};

constexpr std::string_view governor_values =
    "400=1.0 401=1 403=1 416=250 827=1 835=-5 900=1 901=2 906=7 917=12 4406=1 4416=0 4827=3 4835=3 4900=3 "
    "4901=3 4906=3 4917=3 14401=1 14402=0 16400=2000 16401=2031 16402=2300 16403=2330 16404=0 16405=0 "
    "16446=0 16447=0 16448=2905 16449=2908 16450=2917 16451=0 16460=16 16461=0 16462=200 16463=0 16464=0 "
    "16465=0 16466=0 16467=0 16468=0 16469=0 16470=0 16471=0 16472=100 16480=0 16481=100 16482=200 "
    "16483=1000";

TEST_P(ManualTables, of_the_governor_are_refused_for_their_dots_alone) {
    const Read result = read(table("governor"));
    EXPECT_EQ(result.findings.count(diagnostic::Level::error), 1U) << text_of(result.findings);
    EXPECT_NE(text_of(result.findings).find("dots stand for rows that are left out after 16405"),
              std::string::npos)
        << text_of(result.findings);
}

TEST_P(ManualTables, of_the_governor_are_read_with_a_note_for_each_misprint) {
    const Read result = read(without_dots(table("governor")));
    EXPECT_EQ(values_of(result.table), governor_values);
    std::string messages;
    for (const diagnostic::Diagnostic& finding : result.findings.all()) {
        messages += fmt::format("{} {}\n", finding.rule->code, finding.message);
    }
    EXPECT_EQ(
        messages,
        "E0401 409 CanBaudrate is a misprint of the manual, read as 416 CanBaudrate\n"
        "E0401 4409 CanSegmentOrBaudrate is a misprint of the manual, read as 4416 CanSegmentOrBaudrate\n"
        "E0401 4901 ChanType_Setp1Ext is a misprint of the manual, read as 4901 ChanType_Setp2Ext\n");
}

TEST_P(ManualTables, of_the_gateway_are_read_without_their_measurements) {
    const Read result = read(table("gateway"), Device::gateway);
    EXPECT_EQ(values_of(result.table),
              "400=1.0 401=1 402=1 416=250 426=125 427=1 428=127 429=1000 430=100 4400=1 4416=0 4426=0 "
              "16404=0x282 16407=0x382 16411=0x3 16415=0x57F");
    ASSERT_EQ(result.findings.all().size(), 1U) << text_of(result.findings);
    EXPECT_EQ(result.findings.all()[0].message,
              "measurements are skipped: 2410 CanDCNodeState31to16, 2411 CanDCNodeState15to01, "
              "2424 CanPCNodeState31to16, 2425 CanPCNodeState15to01");
}

INSTANTIATE_TEST_SUITE_P(Separated, ManualTables,
                         testing::Values("tabs.txt", "semicolons.csv", "bars.md", "blanks.txt"),
                         [](const auto& instance) {
                             const std::string name = instance.param;
                             return name.substr(0, name.find('.'));
                         });

// --- what separates columns, and what stands between rows ---

TEST(ParameterTable, takes_commas_below_a_header_that_has_them) {
    EXPECT_EQ(values_in("Number,Parameter,Value,Unit\n400,CanStartTimeOutDelay,\"1,5\",s\n401,,2,\n"),
              "400=1.5 401=2");
}

TEST(ParameterTable, suspects_a_decimal_comma_in_a_row_with_a_cell_too_many) {
    EXPECT_EQ(findings_in("Number,Parameter,Value,Unit\n400,CanStartTimeOutDelay,1,5,s\n"),
              "E0502 2:1 the row has 5 cells below a header of 4: is one a decimal comma?\n");
}

TEST(ParameterTable, follows_the_header_to_columns_in_another_order) {
    EXPECT_EQ(values_in("Wert;Einheit;Nummer;Parameter\n1,5;s;400;CanStartTimeOutDelay\n2;;401;\n"),
              "400=1.5 401=2");
}

TEST(ParameterTable, refuses_another_order_that_only_blanks_would_separate) {
    EXPECT_EQ(findings_in("Value Number Parameter\n1 401 CanMyNodeNumber\n"),
              "E0501 1:1 columns in another order than Number, Parameter, Value, Unit need a separator\n");
}

TEST(ParameterTable, refuses_a_header_without_values_once) {
    EXPECT_EQ(findings_in("Number;Parameter;Unit\n401;CanMyNodeNumber;\n403;CanCMNodeNumber;\n"),
              "E0501 1:1 the header names no column Value, so no row has one\n");
}

TEST(ParameterTable, takes_only_the_rows_of_its_device_where_a_column_says_whose_they_are) {
    const std::string_view sheet =
        "Device;Number;Parameter;Value\ngovernor;401;CanMyNodeNumber;1\nGateway;401;CanMyNodeNumber;2\n";
    EXPECT_EQ(values_in(sheet, Device::governor), "401=1");
    EXPECT_EQ(values_in(sheet, Device::gateway), "401=2");
    EXPECT_EQ(findings_in("Device;Number;Value\nmotor;401;1\ngovernor;403;1\n"),
              "E0501 2:1 device `motor` is neither governor nor gateway\n");
}

TEST(ParameterTable, passes_over_text_comments_sections_and_pages) {
    EXPECT_EQ(
        values_in(
            "\xEF\xBB\xBF# as found on 3 May\r\n7.1.1 Node numbers\r\n2. 4 rows follow\r\nThe node is 1, as "
            "usual\r\n\f"
            "// first page\r\n======\r\n401 CanMyNodeNumber 1\r\n\r\nNumber Parameter Value\r\n403 1\r\n"),
        "401=1 403=1");
}

TEST(ParameterTable, points_to_the_column_behind_a_byte_order_mark) {
    EXPECT_EQ(findings_in("\xEF\xBB\xBF"
                          "401 CanMyNodeNumber 99\n"),
              "E0111 1:24 401 CanMyNodeNumber is 99, outside 1..31\n");
}

TEST(ParameterTable, reads_names_as_pdf_and_markdown_print_them) {
    EXPECT_EQ(values_in("| 827 | *FunctSetpoint2Or1* | \xE2\x88\x92"
                        "5 |\n| 4827 | Type\\_Setpoint2Or1 | `3` |\n"
                        "16471 CanOpTPDO4-16Cyc (11) 100 ms\n812\t\t7\n"),
              "812=7 827=-5 4827=3 16471=100");
}

TEST(ParameterTable, accepts_a_row_printed_twice_and_refuses_two_values) {
    EXPECT_EQ(values_in("401 CanMyNodeNumber 1\n401 CanMyNodeNumber 1\n"), "401=1");
    const Read result = read("401 CanMyNodeNumber 1\n\n401 CanMyNodeNumber 2\n");
    EXPECT_EQ(text_of(result.findings), "E0108 3:21 401 CanMyNodeNumber is 2 here and 1 before\n");
    ASSERT_EQ(result.findings.all()[0].related.size(), 1U);
    EXPECT_EQ(result.findings.all()[0].related[0].where.range.start.line, 1U);
}

// --- rows that cannot be read ---

TEST(ParameterTable, refuses_what_is_nearly_a_row) {
    EXPECT_EQ(findings_in("401 CanMyNodeNumber 1\n4O3 CanCMNodeNumber 1\n"),
              "E0501 2:1 `4O3` is no parameter number\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\nO403;CanCMNodeNumber;1\n"),
              "E0501 2:1 a row has `O403` where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401 CanMyNodeNumber 1\nCanCMNodeNumber 1\n"),
              "E0501 2:1 a row has `CanCMNodeNumber` where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\n;CanCMNodeNumber;1\n"),
              "E0501 2:1 a row has no number where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401\tCanMyNodeNumber\t1\n403 CanCMNodeNumber\t1\n"),
              "E0501 2:1 `403 CanCMNodeNumber` is no parameter number\n");
    EXPECT_EQ(findings_in("401 CanMyNodeNumber 1\n70000 X 1\n"),
              "E0501 2:1 `70000` is no parameter number\n");
}

TEST(ParameterTable, refuses_rows_behind_a_mark_or_a_word) {
    for (const std::string_view mark :
         {"*", "+", "-", ">", "x", "Nr", "DG", "Parameter", "1.2", "\xE2\x80\xA2", "a b c", "(1)"}) {
        const std::string found =
            findings_in(fmt::format("401 CanMyNodeNumber 1\n{} 16482 CanOpRPDO1-4Cyc(2) 200 ms\n", mark));
        EXPECT_TRUE(found.starts_with("E0501 2:1 ")) << mark << found;
        EXPECT_TRUE(found.ends_with(" where its parameter's number belongs\n")) << mark << found;
    }
    EXPECT_EQ(findings_in("401 CanMyNodeNumber 1\nNr 403 Parameter CanCMNodeNumber Value 1\n"),
              "E0501 2:1 a row has `Nr` where its parameter's number belongs\n");
    EXPECT_EQ(values_in("401 CanMyNodeNumber 1\nsee 16482\n7.2 of 12 pages\n"), "401=1");
}

TEST(ParameterTable, refuses_rows_with_an_empty_or_another_first_cell) {
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\n;403;CanCMNodeNumber;1\n"),
              "E0501 2:1 a row has no number where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401\tCanMyNodeNumber\t1\n\t403\tCanCMNodeNumber\t1\n"),
              "E0501 2:2 a row has no number where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\nx;403;CanCMNodeNumber;1\n"),
              "E0501 2:1 a row has `x` where its parameter's number belongs\n");
    EXPECT_EQ(findings_in("401\tCanMyNodeNumber\t1\ngovernor\t403\tCanCMNodeNumber\t1\n"),
              "E0501 2:1 a row has `governor` where its parameter's number belongs\n");
    EXPECT_EQ(values_in("401;CanMyNodeNumber;1\n;CanCMNodeNumber;\n;;\nsee;403;\n"), "401=1");
}

TEST(ParameterTable, refuses_a_second_column_of_values) {
    for (const std::string_view columns :
         {"Value|Value", "Value|Value new", "Value|Actual value", "Wert|Wert neu", "Old value|Value",
          "Value|New", "alt|Wert", "Wert|Istwert"}) {
        const std::string found =
            findings_in(fmt::format("|Number|Parameter|{}|Unit|\n|401|CanMyNodeNumber|1|2||\n", columns));
        EXPECT_TRUE(found.starts_with("E0502 1:1 the header names a second column of values, "))
            << columns << found;
    }
    EXPECT_EQ(findings_in("Number Parameter Value Value Unit\n401 CanMyNodeNumber 1 2\n"),
              "E0502 1:1 the header names a second column of values, `Value`\n");
    EXPECT_EQ(findings_in("Nr;Number;Parameter;Value\n1;401;CanMyNodeNumber;1\n"),
              "E0502 1:1 the header names the column Number twice\n");
    EXPECT_EQ(values_in("Number;Parameter;Value;Unit;Default;Default value;Min. value;Maximalwert\n"
                        "401;CanMyNodeNumber;1;;0;0;1;31\n"),
              "401=1");
}

TEST(ParameterTable, takes_no_digit_of_a_name_for_a_value) {
    EXPECT_EQ(findings_in("902 Sensor 2\n"),
              "E0501 1:5 902 has no name known here, so `Sensor` may be its name or part of it\n");
    EXPECT_EQ(findings_in("4902 Type 3 \n"),
              "E0501 1:6 4902 has no name known here, so `Type` may be its name or part of it\n");
    EXPECT_EQ(findings_in("902 2 Sensor 5\n"),
              "E0502 1:14 the row has another number, 5, behind its value\n");
    EXPECT_EQ(findings_in("416 CanBaudrate 250 kbit/s 500\n"),
              "E0502 1:28 the row has another number, 500, behind its value\n");
    EXPECT_EQ(values_in("Number Parameter Value Unit Default\n416 CanBaudrate 250 kbit/s 125\n"), "416=250");
    EXPECT_EQ(values_in("902 2\n903;Sensor 2;3\n827 FunctSetpoint2Or1 5\n"), "827=5 902=2 903=3");
}

TEST(ParameterTable, says_what_is_wrong_with_a_leading_zero) {
    const Read result = read("0400;CanStartTimeOutDelay;1\n");
    EXPECT_EQ(text_of(result.findings), "E0501 1:1 `0400` begins with 0, which no parameter number does\n");
    EXPECT_EQ(result.findings.all()[0].help, "write 400");
}

TEST(ParameterTable, keeps_the_separator_of_its_header) {
    EXPECT_EQ(values_in("Number;Parameter;Value;Unit;Title\n401;CanMyNodeNumber;1;;a|b\tc\n"), "401=1");
    EXPECT_EQ(values_in("|Number|Parameter|Value|Title|\n|401|CanMyNodeNumber|1|a;b\tc|\n"), "401=1");
    EXPECT_EQ(values_in("Number;Parameter;Value\n401 CanMyNodeNumber 1\n403\t\t1\n"), "401=1 403=1");
}

TEST(ParameterTable, reads_quoted_cells_between_tabs) {
    EXPECT_EQ(values_in("16480\t\"CanOpRPDO1-4Cyc(0)\"\t\"1000\"\t\"ms\"\n"), "16480=1000");
}

TEST(ParameterTable, refuses_rows_without_a_number_for_a_value) {
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;;\n"), "E0501 1:1 401 CanMyNodeNumber has no value\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;on;\n"),
              "E0501 1:21 401 CanMyNodeNumber has `on` for a value, which is no number\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1e1;\n"),
              "E0501 1:21 401 CanMyNodeNumber has `1e1` for a value, which is no number\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1,0;\n"),
              "E0110 1:21 401 CanMyNodeNumber takes a whole number, not 1,0\n");
}

TEST(ParameterTable, refuses_dots_wherever_they_stand_for_rows) {
    EXPECT_EQ(findings_in("401 CanMyNodeNumber 1\n...\n"),
              "E0503 2:1 dots stand for rows that are left out after 401\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\n\xE2\x80\xA6;\xE2\x80\xA6;\xE2\x80\xA6\n"),
              "E0503 2:1 dots stand for rows that are left out after 401\n");
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1\n16405..16446;;0\n"),
              "E0503 2:1 dots stand for rows that are left out after 401\n");
    EXPECT_EQ(findings_in(": : :\n"), "E0503 1:1 dots stand for rows that are left out\n");
}

// --- values ---

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
              "E0111 1:17 416 CanBaudrate is 200, none of 125, 250, 500, 1000 kbit/s\n");
    EXPECT_EQ(findings_in("16404;;57FF;Hex\n", Device::gateway),
              "E0111 1:8 16404 CanOpTPDO5-16ID(0) is 57FF, outside 0x0..0x7FF\n");
}

// --- names and devices ---

TEST(ParameterTable, refuses_a_name_of_another_number) {
    EXPECT_EQ(findings_in("401;CanCMNodeNumber;1\n403;;1\n"),
              "E0106 1:1 401 is CanMyNodeNumber, but CanCMNodeNumber is 403\n");
    const Read result = read("416;CanBaudrat;250\n403;;1\n");
    EXPECT_EQ(text_of(result.findings),
              "E0106 1:5 416 is CanBaudrate, but no parameter is named `CanBaudrat`\n");
    EXPECT_EQ(result.findings.all()[0].help, "is it 416 CanBaudrate?");
}

TEST(ParameterTable, refuses_unknown_numbers_with_a_hint) {
    const Read result = read("401;;1\n403;;1\n402;CanDCNodeNumber;1\n1234;;7\n417;CanBaudrat;250\n");
    ASSERT_EQ(result.findings.all().size(), 3U) << text_of(result.findings);
    EXPECT_EQ(result.findings.all()[0].help, "402 CanDCNodeNumber belongs to the gateway");
    EXPECT_EQ(result.findings.all()[1].message, "the governor has no parameter `1234`");
    EXPECT_EQ(result.findings.all()[1].help, "leave out what does not concern CANopen");
    EXPECT_EQ(result.findings.all()[2].help, "did you mean 416 CanBaudrate?");
}

TEST(ParameterTable, skips_rows_foreign_to_canopen_with_one_note) {
    const Read result = read(
        "1;TeethPickUp1;160\n10;StartSpeed;200;1/min\n401;CanMyNodeNumber;1\n100;GainPrime;12;%\n"
        "6100;GainMap(3);401\n");
    EXPECT_EQ(text_of(result.findings),
              "E0507 1:1 skipped: 4 rows that do not concern CANopen: 1, 10, 100, 6100\n");
    EXPECT_EQ(values_of(result.table), "401=1");
    EXPECT_EQ(findings_in("401 1\n1 TeethPickUp1 160\n"),
              "E0507 2:1 skipped: a row that does not concern CANopen: 1\n");
    std::string many = "401;;1\n";
    for (int i = 1; i <= 20; ++i) {
        many += fmt::format("{};Zyklop{};1\n", i, i);
    }
    EXPECT_EQ(
        findings_in(many),
        "E0507 2:1 skipped: 20 rows that do not concern CANopen: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and "
        "8 more\n");
}

TEST(ParameterTable, skips_nothing_that_may_be_a_slip) {
    const auto error = [](std::string_view row) {
        const std::string found = findings_in(fmt::format("403;CanCMNodeNumber;1\n{}\n", row));
        return found.substr(0, found.find(' '));
    };
    EXPECT_EQ(error("4010;CanMyNodNumber;1"), "E0105");
    EXPECT_EQ(error("4010;CanMyNodeNumber;1"), "E0106");
    EXPECT_EQ(error("401;Zyklop;1"), "E0106");
    EXPECT_EQ(error("4010;;1"), "E0105");
    EXPECT_EQ(error("1;401;CanMyNodeNumber;1"), "E0105");
    EXPECT_EQ(error("1;Zyklop;CanMyNodeNumber;1"), "E0105");
    EXPECT_EQ(error("1 401 CanMyNodeNumber"), "E0105");
    EXPECT_EQ(error("1 401 CanMyNodeNumber 1"), "E0502");
    EXPECT_EQ(error("4010 Can MyNodeNumber 1"), "E0105");
    EXPECT_EQ(error("402;CanDCNodeNumber;1"), "E0105");
}

TEST(ParameterTable, of_foreign_rows_alone_is_refused) {
    EXPECT_EQ(findings_in("1;TeethPickUp1;160\n"), "E0506 0:0 the table of the governor has no row\n");
}

TEST(ParameterTable, is_no_page_in_html) {
    for (const std::string_view page : {"<!DOCTYPE html>\n<html>", "\xEF\xBB\xBF\n<HTML><td>401</td>"}) {
        const Read result = read(page);
        EXPECT_EQ(text_of(result.findings), "E0506 1:1 this is a page in HTML and not a table in text\n");
        EXPECT_EQ(result.findings.all()[0].help, "use the CSV or the Markdown of the sheet");
    }
}

TEST(ParameterTable, of_the_wrong_device_is_one_mistake) {
    const std::string path = CGW_TEST_DATA "/tables/manual-gateway.tabs.txt";
    const Read result = read(test::read_text(path), Device::governor);
    EXPECT_EQ(
        text_of(result.findings),
        "E0505 3:1 this looks like a table of the gateway: 18 rows fit only that, 0 only the governor\n");
    EXPECT_EQ(result.findings.all()[0].help, "give it as --gateway");
    EXPECT_TRUE(result.table.values.empty());
}

TEST(ParameterTable, without_a_row_is_refused) {
    EXPECT_EQ(findings_in(""), "E0506 0:0 the table of the governor has no row\n");
    EXPECT_EQ(findings_in("Dear colleague,\nthe table follows\n"),
              "E0506 0:0 the table of the governor has no row\n");
    EXPECT_EQ(findings_in("Device;Number;Value\ngateway;401;1\n"),
              "E0506 0:0 the table has no row of the governor, only of the other device\n");
}

TEST(ParameterTable, is_utf_8) {
    EXPECT_EQ(findings_in("401;CanMyNodeNumber;1;\xB0\n"), "E0003 1:23 byte 0xB0 is not UTF-8\n");
}

// --- anything at all ---

// A line as long as this takes minutes when a pass over it begins anew at each character or cell.
Read read_long_line(std::string_view piece) {
    std::string line;
    while (line.size() < (1U << 17U)) {
        line += piece;
    }
    return read("Number;Parameter;Value;Unit\n401;CanMyNodeNumber;1;\n" + line +
                "\n403;CanCMNodeNumber;1;\n");
}

TEST(ParameterTable, reads_a_long_line_of_dots_at_once) {
    for (const std::string_view dots : {".", ":", "\xE2\x80\xA6", ". "}) {
        const Read many = read_long_line(dots);
        ASSERT_EQ(many.findings.all().size(), 1U) << dots;
        EXPECT_EQ(many.findings.all()[0].rule, &diagnostic::rules::table_ellipsis) << dots;
        EXPECT_EQ(many.findings.all()[0].where.range.start.line, 3U);
    }
}

TEST(ParameterTable, reads_a_long_line_of_separators_at_once) {
    for (const std::string_view separator : {",", "\t", ";", "|", " "}) {
        const Read many = read_long_line(separator);
        EXPECT_EQ(text_of(many.findings), "") << separator;
        EXPECT_EQ(values_of(many.table), "401=1 403=1") << separator;
    }
}

TEST(ParameterTable, survives_every_cut_and_every_changed_byte) {
    const std::string path = CGW_TEST_DATA "/tables/manual-governor.bars.md";
    const std::string whole = test::read_text(path).substr(0, 260);
    const parameter::Catalogue catalogue(catalogue::shipped_rows());
    constexpr std::string_view replacements = "\t;|,\"\\.9\xFF";
    for (std::size_t i = 0; i < whole.size(); ++i) {
        diagnostic::Findings findings;
        read_parameter_table(whole.substr(0, i), "t", Device::governor, catalogue, findings);
        std::string changed = whole;
        changed[i] = replacements[i % replacements.size()];
        read_parameter_table(changed, "t", Device::governor, catalogue, findings);
        for (const diagnostic::Diagnostic& finding : findings.all()) {
            ASSERT_NE(finding.rule, nullptr);
            ASSERT_FALSE(finding.message.empty());
        }
    }
}

}  // namespace
}  // namespace cgw::input
