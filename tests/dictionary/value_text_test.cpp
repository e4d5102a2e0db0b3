#include "dictionary/value_text.hpp"

#include <gtest/gtest.h>

namespace cgw::dictionary {
namespace {

using object::DataType;

std::string number_text(DataType type, std::uint64_t number) {
    return value_text(type, {number});
}

}  // namespace

TEST(ValueText, small_naturals_are_counts_and_large_ones_identifiers) {
    EXPECT_EQ(number_text(DataType::unsigned8, 4), "4");
    EXPECT_EQ(number_text(DataType::unsigned16, 500), "500 (0x1F4)");
    EXPECT_EQ(number_text(DataType::unsigned32, 0x161), "0x00000161");
    EXPECT_EQ(number_text(DataType::unsigned64, ~std::uint64_t{0}), "0xFFFFFFFFFFFFFFFF");
}

TEST(ValueText, negative_numbers_have_a_sign_in_every_width) {
    EXPECT_EQ(number_text(DataType::integer8, 0xFF), "-1");
    EXPECT_EQ(number_text(DataType::integer24, 0x800000), "-8388608");
    EXPECT_EQ(number_text(DataType::integer64, std::uint64_t{1} << 63U), "-9223372036854775808");
    EXPECT_EQ(number_text(DataType::integer16, 0x7FFF), "32767");
}

TEST(ValueText, other_kinds) {
    EXPECT_EQ(number_text(DataType::boolean, 1), "true");
    EXPECT_EQ(number_text(DataType::real32, 0x3FC00000), "1.5");
    EXPECT_EQ(number_text(DataType::real64, 0xBFF8000000000000), "-1.5");
    EXPECT_EQ(value_text(DataType::visible_string, {0, false,
                                                    "a\x1b"
                                                    "b"}),
              "\"a?b\"");
    EXPECT_EQ(value_text(DataType::octet_string, {0, false, std::string("\x01\xA0", 2)}), "01 A0");
    EXPECT_EQ(value_text(DataType::domain, {}), "no bytes");
    EXPECT_EQ(value_text(DataType::unsigned32, {0x180, true}), "$NODEID+0x180");
}

TEST(ValueText, many_octets_are_cut) {
    const std::string text = value_text(DataType::octet_string, {0, false, std::string(1000, 'A')});
    EXPECT_LT(text.size(), 100U);
    EXPECT_NE(text.find("(1000 bytes)"), std::string::npos);
}

TEST(ValueText, mapping_entries_name_the_object) {
    EXPECT_EQ(mapping_text(0x20010110), "2001h:1, 16 bits");
    EXPECT_EQ(mapping_text(0x60000001), "6000h:0, 1 bit");
    EXPECT_EQ(mapping_text(0), "nothing");
    EXPECT_TRUE(is_mapping_entry(0x1A00, 1));
    EXPECT_TRUE(is_mapping_entry(0x17FF, 0x40));
    EXPECT_FALSE(is_mapping_entry(0x1A00, 0));
    EXPECT_FALSE(is_mapping_entry(0x1800, 1));
}

}  // namespace cgw::dictionary
