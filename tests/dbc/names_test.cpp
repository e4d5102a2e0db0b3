#include "dbc/names.hpp"

#include <gtest/gtest.h>

namespace cgw::dbc {

TEST(DbcIdentifier, keeps_names_that_are_identifiers) {
    EXPECT_EQ(identifier("Speed"), "Speed");
    EXPECT_EQ(identifier("AssignIn_Setp1Ext"), "AssignIn_Setp1Ext");
}

TEST(DbcIdentifier, brings_other_characters_to_single_underscores) {
    EXPECT_EQ(identifier("CanOpTPDO4-16Cyc(0)"), "CanOpTPDO4_16Cyc_0");
    EXPECT_EQ(identifier("Öldruck  bar"), "Oeldruck_bar");
    EXPECT_EQ(identifier(" (x) "), "x");
}

TEST(DbcIdentifier, does_not_begin_with_a_digit) {
    EXPECT_EQ(identifier("2nd stage"), "_2nd_stage");
}

TEST(DbcIdentifier, is_never_empty) {
    EXPECT_EQ(identifier(""), "Unnamed");
    EXPECT_EQ(identifier("---"), "Unnamed");
    EXPECT_EQ(identifier("___"), "Unnamed");
}

TEST(DbcIdentifier, is_none_of_the_formats_own_words) {
    EXPECT_EQ(identifier("BO_"), "BO");
    EXPECT_EQ(identifier("BA_DEF_DEF_"), "BA_DEF_DEF");
    EXPECT_EQ(identifier("VERSION"), "_VERSION");
    EXPECT_EQ(identifier("Version"), "Version");
}

TEST(DbcIdentifier, is_cut_but_for_its_ending) {
    const std::string endless(50, 'x');
    EXPECT_EQ(identifier(endless), std::string(32, 'x'));
    EXPECT_EQ(identifier(endless, "_Error"), std::string(26, 'x') + "_Error");
    EXPECT_EQ(identifier(std::string(31, 'x') + " y"), std::string(31, 'x'));
    EXPECT_EQ(identifier("Oil", "_Error"), "Oil_Error");
}

TEST(DbcNames, numbers_what_is_taken) {
    Names names;
    EXPECT_EQ(names.take("Speed"), "Speed");
    EXPECT_EQ(names.take("Speed"), "Speed_2");
    EXPECT_EQ(names.take("SPEED"), "SPEED_3");
    EXPECT_EQ(names.take("Speed_2"), "Speed_2_2");
}

TEST(DbcNames, keep_within_32_characters) {
    Names names;
    const std::string full(32, 'x');
    EXPECT_EQ(names.take(full), full);
    EXPECT_EQ(names.take(full), std::string(30, 'x') + "_2");
    for (int i = 3; i < 10; ++i) {
        names.take(full);
    }
    EXPECT_EQ(names.take(full), std::string(29, 'x') + "_10");
}

}  // namespace cgw::dbc
