#include "base/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

using cgw::base::parse_integer;
using cgw::base::parse_real;
using cgw::base::to_text;

TEST(ParseInteger, takes_the_whole_text_or_nothing) {
    EXPECT_EQ(parse_integer("250"), 250);
    EXPECT_EQ(parse_integer("-5"), -5);
    EXPECT_EQ(parse_integer("+5"), 5);
    EXPECT_EQ(parse_integer("7FF", 16), 0x7FF);
    EXPECT_EQ(parse_integer("1111", 2), 15);
    for (const char* text : {"", "+", "-", "+-5", " 5", "5 ", "5.0", "0x10", "5a"}) {
        EXPECT_EQ(parse_integer(text), std::nullopt) << text;
    }
}

TEST(ParseInteger, refuses_what_does_not_fit_instead_of_saturating) {
    EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(parse_integer("9223372036854775808"), std::nullopt);
    EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(parse_integer("-9223372036854775809"), std::nullopt);
}

TEST(ParseReal, refuses_overflow_and_what_is_not_a_number) {
    EXPECT_EQ(parse_real("1.5"), 1.5);
    EXPECT_EQ(parse_real("+1e3"), 1000.0);
    for (const char* text : {"", "1e400", "inf", "nan", "1,5", "1.5s", "+-1"}) {
        EXPECT_EQ(parse_real(text), std::nullopt) << text;
    }
}

TEST(NumberText, is_the_shortest_that_reads_back) {
    EXPECT_EQ(to_text(250), "250");
    EXPECT_EQ(to_text(-100), "-100");
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(15.625), "15.625");
}
