#include "dictionary/dictionary.hpp"

#include <gtest/gtest.h>

namespace cgw::dictionary {
namespace {

Dictionary three_objects() {
    Dictionary dictionary;
    for (const std::uint16_t index : {std::uint16_t{0x1000}, std::uint16_t{0x1018}, std::uint16_t{0x2000}}) {
        dictionary.objects.emplace_back().index = index;
    }
    for (const std::uint8_t sub_index : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{4}}) {
        dictionary.objects[1].variables.emplace_back().sub_index = sub_index;
    }
    return dictionary;
}

}  // namespace

TEST(Dictionary, finds_objects_by_index) {
    const Dictionary dictionary = three_objects();
    for (const Object& object : dictionary.objects) {
        EXPECT_EQ(dictionary.find(object.index), &object);
    }
    EXPECT_EQ(dictionary.find(0x0FFF), nullptr);
    EXPECT_EQ(dictionary.find(0x1001), nullptr);
    EXPECT_EQ(dictionary.find(0x2001), nullptr);
}

TEST(Dictionary, finds_sub_objects_across_gaps) {
    const Dictionary dictionary = three_objects();
    EXPECT_EQ(dictionary.find(0x1018, 4), &dictionary.objects[1].variables[2]);
    EXPECT_EQ(dictionary.find(0x1018, 2), nullptr);
    EXPECT_EQ(dictionary.find(0x1018, 5), nullptr);
    EXPECT_EQ(dictionary.find(0x1019, 0), nullptr);
    EXPECT_EQ(dictionary.find(0x2000, 0), nullptr);
}

TEST(DictionaryValue, follows_the_node_number_only_when_relative) {
    EXPECT_EQ((Value{0x180, true}.resolve(5)), 0x185U);
    EXPECT_EQ((Value{0x80000180, true}.resolve(127)), 0x800001FFU);
    EXPECT_EQ((Value{0x282, false}.resolve(5)), 0x282U);
}

}  // namespace cgw::dictionary
