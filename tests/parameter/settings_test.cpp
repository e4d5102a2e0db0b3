#include "parameter/settings.hpp"

#include <gtest/gtest.h>

namespace {

using cgw::parameter::Assignment;
using cgw::parameter::Device;
using cgw::parameter::external_limits;
using cgw::parameter::ParameterSet;
using cgw::parameter::Row;
using cgw::parameter::Scaling;
using cgw::parameter::Settings;

constexpr Row node{.number = 401, .name = "CanMyNodeNumber"};
constexpr Row low{.number = 980, .name = "OilPressSensorLow"};
constexpr Row high{.number = 981, .name = "OilPressSensorHigh"};

TEST(ParameterSet, gives_back_what_was_assigned) {
    ParameterSet set;
    ASSERT_TRUE(set.assign({.row = &node, .value = 7, .spelling = "CanMyNodeNumber"}));
    ASSERT_NE(set.find(401), nullptr);
    EXPECT_EQ(set.find(401)->spelling, "CanMyNodeNumber");
    EXPECT_EQ(set.value(401), 7);
    EXPECT_EQ(set.integer(401), 7U);
}

TEST(ParameterSet, reads_what_is_not_assigned_as_0) {
    const ParameterSet set;
    EXPECT_EQ(set.find(401), nullptr);
    EXPECT_EQ(set.value(401), 0);
    EXPECT_EQ(set.integer(401), 0U);
}

TEST(ParameterSet, keeps_the_first_of_two_values) {
    ParameterSet set;
    ASSERT_TRUE(set.assign({.row = &node, .value = 7}));
    EXPECT_FALSE(set.assign({.row = &node, .value = 8}));
    EXPECT_EQ(set.value(401), 7);
    EXPECT_EQ(set.all().size(), 1U);
}

TEST(ParameterSet, cuts_integers_to_their_range) {
    const auto integer = [](double value) {
        ParameterSet set;
        set.assign({.row = &node, .value = value});
        return set.integer(401);
    };
    EXPECT_EQ(integer(-5), 0U);
    EXPECT_EQ(integer(1.9), 1U);
    EXPECT_EQ(integer(4294967295.0), 4294967295U);
    EXPECT_EQ(integer(1e12), 4294967295U);
}

TEST(ExternalLimits, are_the_constants_of_the_row) {
    const Row row{.number = 2000, .scaling = Scaling{0, 65535, 0.0, 4000.0, 0, 0}};
    const auto limits = external_limits(row, {});
    ASSERT_TRUE(limits.has_value());
    EXPECT_EQ(limits->minimum, 0);
    EXPECT_EQ(limits->maximum, 4000);
}

TEST(ExternalLimits, come_from_reference_parameters_where_the_row_names_them) {
    const Row row{.number = 2905, .scaling = Scaling{0, 65535, std::nullopt, std::nullopt, 980, 981}};
    ParameterSet set;
    set.assign({.row = &low, .value = 1});
    set.assign({.row = &high, .value = 11});
    const auto limits = external_limits(row, set);
    ASSERT_TRUE(limits.has_value());
    EXPECT_EQ(limits->minimum, 1);
    EXPECT_EQ(limits->maximum, 11);
}

TEST(ExternalLimits, mix_a_constant_and_a_reference) {
    const Row row{.number = 2915, .scaling = Scaling{0, 65535, 0.0, std::nullopt, 0, 981}};
    ParameterSet set;
    set.assign({.row = &high, .value = 300});
    ASSERT_TRUE(external_limits(row, set).has_value());
    EXPECT_EQ(external_limits(row, set)->maximum, 300);
}

TEST(ExternalLimits, take_0_for_a_lowest_reference_that_is_not_set) {
    const Row row{.number = 2905, .scaling = Scaling{0, 65535, std::nullopt, std::nullopt, 980, 981}};
    ParameterSet set;
    set.assign({.row = &high, .value = 11});
    ASSERT_TRUE(external_limits(row, set).has_value());
    EXPECT_EQ(external_limits(row, set)->minimum, 0);
    set.assign({.row = &low, .value = 0});
    EXPECT_EQ(external_limits(row, set)->minimum, 0);
}

TEST(ExternalLimits, are_not_known_while_the_highest_reference_is_0) {
    const Row row{.number = 2905, .scaling = Scaling{0, 65535, std::nullopt, std::nullopt, 980, 981}};
    ParameterSet set;
    set.assign({.row = &low, .value = -1});
    EXPECT_FALSE(external_limits(row, set).has_value());
    set.assign({.row = &high, .value = 0});
    EXPECT_FALSE(external_limits(row, set).has_value());
}

TEST(ExternalLimits, may_end_at_a_constant_0) {
    const Row row{.number = 2905, .scaling = Scaling{0, 65535, std::nullopt, 0.0, 980, 0}};
    ParameterSet set;
    set.assign({.row = &low, .value = -1});
    ASSERT_TRUE(external_limits(row, set).has_value());
    EXPECT_EQ(external_limits(row, set)->minimum, -1);
}

TEST(ExternalLimits, are_not_known_without_scaling_or_with_a_blank_or_when_equal) {
    EXPECT_FALSE(external_limits(Row{.number = 2990}, {}).has_value());
    const Row blank{.number = 2917, .scaling = Scaling{.internal_maximum = 65535}};
    EXPECT_FALSE(external_limits(blank, {}).has_value());
    const Row row{.number = 2905, .scaling = Scaling{0, 65535, std::nullopt, std::nullopt, 980, 981}};
    ParameterSet set;
    set.assign({.row = &low, .value = 5});
    set.assign({.row = &high, .value = 5});
    EXPECT_FALSE(external_limits(row, set).has_value());
}

TEST(Settings, hold_one_set_for_each_device) {
    Settings settings;
    settings.governor.assign({.row = &node, .value = 1});
    settings.gateway.assign({.row = &node, .value = 2});
    EXPECT_EQ(settings.of(Device::governor).value(401), 1);
    EXPECT_EQ(settings.of(Device::gateway).value(401), 2);
}

}  // namespace
