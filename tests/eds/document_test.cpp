#include "eds/document.hpp"

#include <gtest/gtest.h>

namespace cgw::eds {

TEST(EdsDocument, prints_sections_entries_and_comments_in_their_order) {
    Document document;
    document.preamble = {{Line::Kind::comment, "", " first"}, {Line::Kind::blank, "", ""}};
    document.section("FileInfo").entry("FileName", "a.eds").comment("two").entry("Empty", "");
    document.section("1000").entry("ParameterName", "Device Type");
    EXPECT_EQ(print(document),
              "; first\r\n"
              "\r\n"
              "\r\n"
              "[FileInfo]\r\n"
              "FileName=a.eds\r\n"
              ";two\r\n"
              "Empty=\r\n"
              "\r\n"
              "[1000]\r\n"
              "ParameterName=Device Type\r\n");
}

TEST(EdsDocument, does_not_begin_with_a_blank_line) {
    Document document;
    document.section("FileInfo");
    EXPECT_EQ(print(document), "[FileInfo]\r\n");
    EXPECT_EQ(print(Document{}), "");
}

TEST(EdsDocument, finds_sections_and_keys_whatever_their_case) {
    Document document;
    document.section("DeviceInfo")
        .comment("VendorName=nobody")
        .entry("VendorName", "first")
        .entry("VENDORNAME", "2nd");
    ASSERT_NE(document.find("deviceinfo"), nullptr);
    const Section& section = *document.find("DEVICEINFO");
    ASSERT_NE(section.find("vendorname"), nullptr);
    EXPECT_EQ(*section.find("vendorname"), "first");
    EXPECT_EQ(section.find("VendorNam"), nullptr);
    EXPECT_EQ(section.find("VendorName2"), nullptr);
    EXPECT_EQ(document.find("Device"), nullptr);
}

}  // namespace cgw::eds
