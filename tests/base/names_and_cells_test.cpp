// Texts that every room writes alike: CANopen's things, cells of tables, characters of ASCII.
#include <gtest/gtest.h>

#include "base/ascii.hpp"
#include "base/canopen_text.hpp"
#include "base/files.hpp"
#include "base/text_cells.hpp"

namespace base = cgw::base;

TEST(CanopenText, writes_objects_identifiers_and_pdos_as_the_manual_does) {
    EXPECT_EQ(base::object_text(0x2003), "2003h");
    EXPECT_EQ(base::object_text(0x0006, 12), "0006h:12");
    EXPECT_EQ(base::identifier_text(0x3), "003h");
    EXPECT_EQ(base::identifier_text(0x681), "681h");
    EXPECT_EQ(base::pdo_name(true, 16), "TPDO16");
    EXPECT_EQ(base::pdo_name(false, 2), "RPDO2");
}

TEST(CanopenText, does_not_round_milliseconds) {
    EXPECT_EQ(base::milliseconds(15625), "15.625");
    EXPECT_EQ(base::milliseconds_text(110000), "110 ms");
    EXPECT_EQ(base::milliseconds_text(0), "0 ms");
}

TEST(TextCells, of_markdown_hold_no_markup_and_one_line) {
    EXPECT_EQ(base::markdown_cell("a|b *c* _d_ `e` [f](g) <h> i\nj"),
              "a\\|b \\*c\\* \\_d\\_ \\`e\\` \\[f](g) \\<h> i j");
    EXPECT_EQ(base::markdown_cell("\\ &amp; #1 ~x~"), "\\\\ \\&amp; \\#1 \\~x\\~");
    EXPECT_EQ(base::one_line("a\tb\x7F"), "a b ");
}

TEST(TextCells, of_csv_are_quoted_where_needed) {
    EXPECT_EQ(base::csv_field("plain"), "plain");
    EXPECT_EQ(base::csv_field(""), "");
    EXPECT_EQ(base::csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(base::csv_field("say \"a\""), "\"say \"\"a\"\"\"");
    EXPECT_EQ(base::csv_field("two\nlines"), "\"two\nlines\"");
}

TEST(TextCells, of_csv_are_no_formulas_and_numbers_stay_numbers) {
    EXPECT_EQ(base::csv_field("=1+1"), "'=1+1");
    EXPECT_EQ(base::csv_field("@A1"), "'@A1");
    EXPECT_EQ(base::csv_field("-A1"), "'-A1");
    EXPECT_EQ(base::csv_field("+A1,2"), "\"'+A1,2\"");
    EXPECT_EQ(base::csv_field("-32768"), "-32768");
    EXPECT_EQ(base::csv_field("-0.5"), "-0.5");
}

TEST(Ascii, tells_characters_apart) {
    EXPECT_TRUE(base::is_letter_or_digit('z') && base::is_letter_or_digit('Z') &&
                base::is_letter_or_digit('9'));
    EXPECT_FALSE(base::is_letter_or_digit('_') || base::is_letter('1') || base::is_digit('a'));
    EXPECT_TRUE(base::is_hexadecimal_digit('f') && base::is_hexadecimal_digit('F'));
    EXPECT_FALSE(base::is_hexadecimal_digit('g'));
    EXPECT_EQ(base::upper('a'), 'A');
    EXPECT_EQ(base::upper('1'), '1');
    EXPECT_TRUE(base::consists_of("0123", base::digits));
    EXPECT_FALSE(base::consists_of("01x", base::digits));
    EXPECT_FALSE(base::consists_of("", base::digits));
}

TEST(Ascii, trims_blanks_at_both_ends) {
    EXPECT_EQ(base::trimmed("  416 \t"), "416");
    EXPECT_EQ(base::trimmed("a b"), "a b");
    EXPECT_EQ(base::trimmed("   "), "");
    EXPECT_EQ(base::trimmed(" \r", " \r"), "");
    EXPECT_EQ(base::trimmed(""), "");
}

TEST(Beside, a_name_in_a_file_is_relative_to_it) {
    EXPECT_EQ(base::beside("plants/a.toml", "b.toml"), "plants/b.toml");
    EXPECT_EQ(base::beside("a.toml", "b.toml"), "b.toml");
    EXPECT_EQ(base::beside("a.toml", "/c/b.toml"), "/c/b.toml");
    EXPECT_EQ(base::beside("-", "b.toml"), "b.toml");
}
