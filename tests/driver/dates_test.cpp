#include "driver/dates.hpp"

#include <gtest/gtest.h>

using cgw::driver::artefact_date;
using cgw::parameter::Date;

TEST(ArtefactDate, is_the_files_own_then_the_epoch_then_the_manuals) {
    const Date own{2026, 3, 1};
    EXPECT_EQ(*artefact_date(own, "0"), own);
    EXPECT_EQ(*artefact_date(std::nullopt, "0"), (Date{1970, 1, 1}));
    EXPECT_EQ(*artefact_date(std::nullopt, "1700000000"), (Date{2023, 11, 14}));
    EXPECT_EQ(*artefact_date(std::nullopt, nullptr), (Date{2004, 5, 19}));
    EXPECT_EQ(*artefact_date(std::nullopt, ""), (Date{2004, 5, 19}));
}

TEST(ArtefactDate, refuses_an_epoch_that_is_no_number_of_seconds) {
    for (const char* epoch : {"now", "-1", "1.5", "253402300800", "99999999999999999999"}) {
        ASSERT_FALSE(artefact_date(std::nullopt, epoch)) << epoch;
        EXPECT_NE(artefact_date(std::nullopt, epoch).error().message.find(epoch), std::string::npos);
    }
    EXPECT_EQ(*artefact_date(std::nullopt, "253402300799"), (Date{9999, 12, 31}));
}
