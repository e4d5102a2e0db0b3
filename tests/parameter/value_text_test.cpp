#include "parameter/value_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace {

using cgw::parameter::Base;
using cgw::parameter::quantity_text;
using cgw::parameter::range_text;
using cgw::parameter::Row;
using cgw::parameter::value_text;

constexpr std::array<std::uint32_t, 3> rates{125, 250, 500};

TEST(ValueText, is_in_the_number_base_of_the_parameter) {
    EXPECT_EQ(value_text(Row{}, 15.625), "15.625");
    EXPECT_EQ(value_text(Row{}, -100), "-100");
    EXPECT_EQ(value_text(Row{.base = Base::hexadecimal}, 0x282), "0x282");
    EXPECT_EQ(value_text(Row{.base = Base::hexadecimal}, 0), "0");
}

TEST(ValueText, is_decimal_where_hexadecimal_digits_cannot_say_it) {
    EXPECT_EQ(value_text(Row{.base = Base::hexadecimal}, -1), "-1");
    EXPECT_EQ(value_text(Row{.base = Base::hexadecimal}, 1.5), "1.5");
    EXPECT_EQ(value_text(Row{.base = Base::hexadecimal}, 4294967296.0), "4294967296");
}

TEST(QuantityText, has_the_unit_behind_the_value) {
    EXPECT_EQ(quantity_text(Row{.unit = "ms"}, 100), "100 ms");
    EXPECT_EQ(quantity_text(Row{}, 100), "100");
}

TEST(RangeText, says_what_is_known) {
    EXPECT_EQ(range_text(Row{.minimum = 1, .maximum = 31}), "1..31");
    EXPECT_EQ(range_text(Row{.minimum = 0, .maximum = 100, .unit = "s"}), "0..100 s");
    EXPECT_EQ(range_text(Row{.minimum = 0, .maximum = 0x7FF, .base = Base::hexadecimal}), "0..0x7FF");
    EXPECT_EQ(range_text(Row{.minimum = 0, .unit = "%"}), "at least 0 %");
    EXPECT_EQ(range_text(Row{.maximum = 5}), "at most 5");
    EXPECT_EQ(range_text(Row{.choices = rates, .unit = "kbit/s"}), "125, 250 or 500 kbit/s");
    EXPECT_EQ(range_text(Row{.unit = "1/min"}), "1/min");
    EXPECT_EQ(range_text(Row{}), "");
}

TEST(ParameterRow, allows_its_choices_only) {
    const Row row{.choices = rates};
    EXPECT_TRUE(row.has_range() && row.allows(250));
    EXPECT_FALSE(row.allows(200));
}

TEST(ParameterRow, allows_finite_numbers_within_its_limits) {
    const Row row{.minimum = 1, .maximum = 31};
    EXPECT_TRUE(row.has_range() && row.allows(1) && row.allows(31));
    EXPECT_FALSE(row.allows(0.5) || row.allows(32) || row.allows(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_TRUE((Row{.minimum = 1}).allows(1e9));
    EXPECT_FALSE((Row{.maximum = 1}).has_range() && (Row{.maximum = 1}).allows(2));
    EXPECT_FALSE(Row{}.has_range() || Row{}.allows(std::numeric_limits<double>::infinity()));
}

}  // namespace
