#include "eds_check/dates.hpp"

#include <gtest/gtest.h>

namespace cgw::eds_check {

TEST(Dates, are_month_day_and_year) {
    for (const char* text : {"01-15-2024", "12-31-1999", "02-29-2000", "02-29-2024"}) {
        EXPECT_TRUE(is_date(text)) << text;
    }
    for (const char* text :
         {"", "13-01-2024", "00-01-2024", "02-29-2023", "02-29-1900", "04-31-2024", "1-15-2024", "01-15-24",
          "15.01.2024", "2024-01-15", "01-15-2024 ", "-1-15-2024"}) {
        EXPECT_FALSE(is_date(text)) << text;
    }
}

TEST(Dates, with_the_name_of_a_month_can_be_meant_in_one_way) {
    EXPECT_EQ(as_date("15-Jan-2024"), "01-15-2024");
    EXPECT_EQ(as_date("5-dec-1999"), "12-05-1999");
    for (const char* text : {"05-06-2024", "2024-01-15", "31-Apr-2024", "15-Jan-24", "Jan-15-2024", ""}) {
        EXPECT_EQ(as_date(text), std::nullopt) << text;
    }
}

TEST(Times, are_of_twelve_hours) {
    for (const char* text : {"12:00AM", "01:00AM", "11:59PM", "12:59PM"}) {
        EXPECT_TRUE(is_time(text)) << text;
    }
    for (const char* text : {"", "00:00AM", "9:05AM", "13:00PM", "10:60AM", "10:00am", "10:00", "10:00 AM"}) {
        EXPECT_FALSE(is_time(text)) << text;
    }
}

TEST(Times, of_24_hours_or_with_one_digit_can_be_meant_in_one_way) {
    EXPECT_EQ(as_time("00:00AM"), "12:00AM");
    EXPECT_EQ(as_time("9:05AM"), "09:05AM");
    EXPECT_EQ(as_time("9:05 pm"), "09:05PM");
    EXPECT_EQ(as_time("13:05PM"), "01:05PM");
    EXPECT_EQ(as_time("17:45"), "05:45PM");
    EXPECT_EQ(as_time("00:30"), "12:30AM");
    EXPECT_EQ(as_time("12:30"), "12:30PM");
    for (const char* text : {"", "noon", "13:05AM", "00:30PM", "24:00", "9:5AM", "10:60", "AM", "::AM"}) {
        EXPECT_EQ(as_time(text), std::nullopt) << text;
    }
}

}  // namespace cgw::eds_check
