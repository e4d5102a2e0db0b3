// Printed tables: what separates columns, and what stands between rows.
#include "input/printed_table.hpp"

namespace cgw::input {
namespace {

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

}  // namespace
}  // namespace cgw::input
