#include "explain/query.hpp"

#include <gtest/gtest.h>

namespace {

using cgw::explain::parse_abort_code;
using cgw::explain::parse_object;
using cgw::explain::parse_parameter_number;
using cgw::explain::parse_value;

int index_of(std::string_view text) {
    const auto object = parse_object(text);
    return object ? object->index : -1;
}

int sub_of(std::string_view text) {
    const auto object = parse_object(text);
    return object && object->sub ? *object->sub : -1;
}

TEST(ExplainQuery, objects_are_hexadecimal_by_mark) {
    EXPECT_EQ(index_of("2005h"), 0x2005);
    EXPECT_EQ(index_of("0x2005"), 0x2005);
    EXPECT_EQ(index_of("0X1a0F"), 0x1A0F);
    EXPECT_EQ(index_of("2005H"), 0x2005);
    EXPECT_EQ(sub_of("2005h"), -1);
    EXPECT_EQ(index_of("2005"), -1);
    EXPECT_EQ(index_of("0x12345"), -1);
    EXPECT_EQ(index_of("h"), -1);
    EXPECT_EQ(index_of("0xh"), -1);
    EXPECT_EQ(index_of("-1h"), -1);
}

TEST(ExplainQuery, sub_indices_are_decimal_unless_marked) {
    EXPECT_EQ(sub_of("2000h:1"), 1);
    EXPECT_EQ(sub_of("0x2000:0x0A"), 10);
    EXPECT_EQ(sub_of("2001h:52"), 52);
    EXPECT_EQ(sub_of("2000h01"), 1);  // as the manual prints it
    EXPECT_EQ(index_of("2000h01"), 0x2000);
    EXPECT_EQ(index_of("2000:1"), -1);
    EXPECT_EQ(index_of("2000h:256"), -1);
    EXPECT_EQ(index_of("2000h:"), -1);
}

TEST(ExplainQuery, abort_codes_have_eight_digits) {
    EXPECT_EQ(parse_abort_code("0x06010002"), 0x06010002U);
    EXPECT_EQ(parse_abort_code("06010002h"), 0x06010002U);
    EXPECT_EQ(parse_abort_code("0601 0002h"), 0x06010002U);
    EXPECT_FALSE(parse_abort_code("06010002"));
    EXPECT_FALSE(parse_abort_code("0x0601002"));
    EXPECT_FALSE(parse_abort_code("0x060100020"));
}

TEST(ExplainQuery, parameters_are_decimal) {
    EXPECT_EQ(parse_parameter_number("12412"), 12412);
    EXPECT_FALSE(parse_parameter_number("0x10"));
    EXPECT_FALSE(parse_parameter_number("+5"));
    EXPECT_FALSE(parse_parameter_number("70000"));
    EXPECT_FALSE(parse_parameter_number(""));
}

TEST(ExplainQuery, values_have_every_notation) {
    EXPECT_EQ(parse_value("9"), 9U);
    EXPECT_EQ(parse_value("0x0102"), 0x102U);
    EXPECT_EQ(parse_value("102h"), 0x102U);
    EXPECT_EQ(parse_value("0b101"), 5U);
    EXPECT_EQ(parse_value("4294967295"), 0xFFFFFFFFU);
    EXPECT_FALSE(parse_value("4294967296"));
    EXPECT_FALSE(parse_value("-1"));
    EXPECT_FALSE(parse_value("1,5"));
    EXPECT_FALSE(parse_value(""));
}

}  // namespace
