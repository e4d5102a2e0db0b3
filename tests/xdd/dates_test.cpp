#include "xdd/dates.hpp"

#include <gtest/gtest.h>

namespace cgw::xdd {

TEST(XddDates, turn_the_dates_of_an_eds_round) {
    EXPECT_EQ(xml_date("05-19-2004"), "2004-05-19");
    EXPECT_EQ(eds_date("2004-05-19"), "05-19-2004");
    EXPECT_EQ(eds_date("2004-05-19+02:00"), "05-19-2004");
}

TEST(XddDates, know_noon_and_midnight) {
    EXPECT_EQ(xml_time("12:00AM"), "00:00:00");
    EXPECT_EQ(xml_time("12:05PM"), "12:05:00");
    EXPECT_EQ(xml_time("01:59pm"), "13:59:00");
    EXPECT_EQ(eds_time("00:00:00"), "12:00AM");
    EXPECT_EQ(eds_time("12:05:59.25Z"), "12:05PM");
    EXPECT_EQ(eds_time("23:59:00"), "11:59PM");
}

TEST(XddDates, make_nothing_of_what_is_no_date) {
    for (const char* const text : {"", "13-01-2004", "00-01-2004", "01-32-2004", "1-1-2004", "01-01-04",
                                   "01-01-2004x", "05.19.2004", "19-May-2004"}) {
        EXPECT_EQ(xml_date(text), "") << text;
    }
    for (const char* const text : {"", "00:00AM", "13:00PM", "12:60PM", "9:05AM", "12:00", "12:00XM"}) {
        EXPECT_EQ(xml_time(text), "") << text;
    }
    for (const char* const text : {"", "2004-13-01", "2004-1-1", "0001-01-01", "x"}) {
        EXPECT_EQ(eds_date(text), "") << text;
    }
    for (const char* const text : {"", "24:00:00", "12:60", "1:00"}) {
        EXPECT_EQ(eds_time(text), "") << text;
    }
}

}  // namespace cgw::xdd
