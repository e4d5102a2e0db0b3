#include "parameter/row.hpp"

#include <gtest/gtest.h>

namespace {

using cgw::parameter::Device;
using cgw::parameter::label;
using cgw::parameter::List;
using cgw::parameter::Row;
using cgw::parameter::to_engineering;
using cgw::parameter::to_text;

TEST(ParameterRow, is_labelled_by_number_and_name) {
    EXPECT_EQ(label(Row{.number = 16404, .name = "CanOpTPDO5-16ID(0)"}), "16404 CanOpTPDO5-16ID(0)");
}

TEST(ParameterRow, without_a_name_is_labelled_by_its_number) {
    EXPECT_EQ(label(Row{.number = 812}), "812");
}

TEST(ParameterRow, is_settable_unless_it_is_a_measurement) {
    EXPECT_TRUE((Row{.list = List::parameter}).settable());
    EXPECT_TRUE((Row{.list = List::function}).settable());
    EXPECT_TRUE((Row{.list = List::curve}).settable());
    EXPECT_FALSE((Row{.list = List::measurement}).settable());
}

TEST(ParameterRow, is_a_bit_when_it_is_one_bit_wide) {
    EXPECT_TRUE((Row{.width = 1}).is_bit());
    EXPECT_FALSE((Row{.width = 8}).is_bit());
    EXPECT_FALSE((Row{.width = 0}).is_bit());
}

TEST(ParameterDevice, is_called_as_the_tables_of_the_file) {
    EXPECT_EQ(to_text(Device::governor), "governor");
    EXPECT_EQ(to_text(Device::gateway), "gateway");
}

TEST(ToEngineering, follows_the_line_through_both_limits) {
    EXPECT_DOUBLE_EQ(to_engineering(0, 0, 65535, -100, 1000), -100);
    EXPECT_DOUBLE_EQ(to_engineering(65535, 0, 65535, -100, 1000), 1000);
    EXPECT_NEAR(to_engineering(24576, 0, 65535, 0, 4000), 1500, 0.1);
    EXPECT_DOUBLE_EQ(to_engineering(-32768, -32768, 32767, -50, 50), -50);
    EXPECT_DOUBLE_EQ(to_engineering(100, 0, 50, 0, 1), 2);  // beyond the limits the line goes on
}

}  // namespace
