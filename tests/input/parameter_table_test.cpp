// Printed tables as a whole: names and devices, the examples of the rules, and anything at all.
#include "input/printed_table.hpp"

#include <algorithm>
#include <filesystem>

#include "diagnostic/rules/tables.hpp"
#include "support/golden.hpp"

namespace cgw::input {
namespace {

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
