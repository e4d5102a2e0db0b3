#include "partner/text.hpp"

#include <gtest/gtest.h>

namespace cgw::partner {

TEST(PartnerComment, is_one_line_of_ascii_that_ends_no_comment) {
    EXPECT_EQ(comment("Größe 5 °C"), "Groesse 5 degC");
    EXPECT_EQ(comment("a */ b /* c *) d // e"), "a _/ b /_ c _) d /| e");
    EXPECT_EQ(comment("x\\\ny {p} ?\?/ \"q\" $N"), "x_ y _p_ __/ 'q' _N");
}

TEST(PartnerComment, is_bounded) {
    EXPECT_EQ(comment(std::string(100'000, 'a')).size(), 160U);
    EXPECT_TRUE(comment(std::string(100'000, 'a')).ends_with("..."));
}

TEST(PartnerCString, keeps_every_byte_and_ends_nowhere_else) {
    EXPECT_EQ(c_string("1/min"), "\"1/min\"");
    EXPECT_EQ(c_string("\xC2\xB0"
                       "C"),
              "\"\\302\\260C\"");
    EXPECT_EQ(c_string("\"\\?\n1"), "\"\\042\\134\\077\\0121\"");
}

TEST(PartnerText, is_cut_between_characters) {
    EXPECT_EQ(cut("\xC2\xB0\xC2\xB0", 3), "\xC2\xB0");
    EXPECT_EQ(cut("abc", 3), "abc");
    EXPECT_EQ(cut("abc", 0), "");
}

TEST(PartnerReal, is_a_real_in_every_language) {
    EXPECT_EQ(real(250), "250.0");
    EXPECT_EQ(real(-0.0625), "-0.0625");
    EXPECT_EQ(real(-0.0), "-0.0");
    EXPECT_EQ(real(1e300), "1e+300");
}

}  // namespace cgw::partner
