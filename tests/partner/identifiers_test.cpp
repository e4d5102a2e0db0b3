#include "partner/identifiers.hpp"

#include <gtest/gtest.h>

#include "base/ascii.hpp"

namespace cgw::partner {
namespace {

Identifiers names() {
    return Identifiers(structured_text_words());
}

}  // namespace

TEST(PartnerIdentifiers, keep_what_is_allowed) {
    Identifiers all = names();
    EXPECT_EQ(all.take("Speed"), "Speed");
    EXPECT_EQ(all.take("AssignIn_Setp1Ext"), "AssignIn_Setp1Ext");
}

TEST(PartnerIdentifiers, are_no_words_of_the_language) {
    Identifiers all = names();
    EXPECT_EQ(all.take("Real"), "Real_2");
    EXPECT_EQ(all.take("END_IF"), "END_IF_2");
    EXPECT_EQ(all.take("Real_2"), "Real_2_2");
}

TEST(PartnerIdentifiers, have_single_underscores_and_none_at_the_ends) {
    Identifiers all = names();
    EXPECT_EQ(all.take("__a__b_"), "a_b");
    EXPECT_EQ(all.take("A_B"), "A_B_2") << "upper and lower case are the same";
    EXPECT_EQ(all.take("9x"), "S9x");
    EXPECT_EQ(all.take("_"), "Signal");
    EXPECT_EQ(all.take("a-\xC3\xA4 b"), "a_b_3");
}

TEST(PartnerIdentifiers, stay_short_and_apart_whatever_is_asked_for) {
    Identifiers all = names();
    const std::string long_name(31, 'x');
    std::set<std::string> taken;
    for (int i = 0; i < 300; ++i) {
        const std::string name = all.take(i % 2 == 0 ? long_name + "_" : std::string(100'000, 'X'));
        EXPECT_LE(name.size(), 32U);
        EXPECT_EQ(name.find("__"), std::string::npos);
        EXPECT_TRUE(taken.insert(base::lowered(name)).second) << name;
    }
}

}  // namespace cgw::partner
