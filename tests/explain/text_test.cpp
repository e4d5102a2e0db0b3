#include "explain/text.hpp"

#include <gtest/gtest.h>

namespace {

using cgw::explain::merged_text;
using cgw::explain::replaced;
using cgw::explain::wrap;

TEST(ExplainText, wraps_at_blanks) {
    EXPECT_EQ(wrap("one two three", 7), (std::vector<std::string>{"one two", "three"}));
    EXPECT_EQ(wrap("one two three", 13), (std::vector<std::string>{"one two three"}));
    EXPECT_EQ(wrap("incomprehensibilities of x", 5),
              (std::vector<std::string>{"incomprehensibilities", "of x"}));
    EXPECT_EQ(wrap("", 10), (std::vector<std::string>{""}));
    EXPECT_EQ(wrap("ends ", 4), (std::vector<std::string>{"ends"}));
}

TEST(ExplainText, texts_that_differ_in_numbers_become_one) {
    EXPECT_EQ(merged_text("word 1 of TPDO4", "word 4 of TPDO4"), "word 1..4 of TPDO4");
    EXPECT_EQ(merged_text("identifier of TPDO5; 0 only", "identifier of TPDO16; 0 only"),
              "identifier of TPDO5..16; 0 only");
    EXPECT_EQ(merged_text("1804h:1", "180Fh:1"), "1804h..180Fh:1");
    EXPECT_EQ(merged_text("Name(0)", "Name(11)"), "Name(0..11)");
    EXPECT_EQ(merged_text("same", "same"), "same");
    EXPECT_EQ(merged_text("", ""), "");
}

TEST(ExplainText, texts_that_differ_otherwise_stay_apart) {
    EXPECT_FALSE(merged_text("SensorLow", "SensorHigh"));
    EXPECT_FALSE(merged_text("word 1", "word 1 of TPDO4"));
    EXPECT_FALSE(merged_text("word 1 of", "word 1 or"));
    EXPECT_FALSE(merged_text("Word4Assign", "Word5Assign"));
}

TEST(ExplainText, replaces_every_occurrence) {
    EXPECT_EQ(replaced("a\"b\"", "\"", "\"\""), "a\"\"b\"\"");
    EXPECT_EQ(replaced("abc", "x", "y"), "abc");
}

}  // namespace
