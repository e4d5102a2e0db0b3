// Where findings about other programs' EDS files point to.
#include "eds/value_places.hpp"

#include <gtest/gtest.h>

namespace cgw::eds {
namespace {

constexpr const char* text =
    "[DeviceInfo]\n"          // 1
    "BaudRate_125=1\n"        // 2
    "[1017]\n"                // 3
    "ParameterName=beat\n"    // 4
    "DefaultValue = 100\n"    // 5
    "ParameterValue=200\n"    // 6
    "[1800]\n"                // 7
    "SubNumber=3\n"           // 8
    "[1800sub1]\n"            // 9
    "DefaultValue=0x181\n"    // 10
    "ParameterValue=\n"       // 11
    "[1800sub2]\n"            // 12
    "ParameterName=type\n"    // 13
    "[1A00]\n"                // 14
    "CompactSubObj=3\n"       // 15
    "DefaultValue=0\n"        // 16
    "[1A00Value]\n"           // 17
    "NrOfEntries=1\n"         // 18
    "2=0x60000108\n"          // 19
    "[DeviceComissioning]\n"  // 20
    "Baudrate=250\n";         // 21

TEST(ValuePlaces, of_an_object_are_its_value_its_default_or_its_section) {
    const ValuePlaces places(text);
    using diagnostic::Position;
    EXPECT_EQ(places.of_object(0x1017, 0).start, (Position{6, 16}));   // the value of the one node
    EXPECT_EQ(places.of_object(0x1800, 1).start, (Position{10, 14}));  // an empty one is none
    EXPECT_EQ(places.of_object(0x1800, 2).start, (Position{12, 2}));
    EXPECT_EQ(places.of_object(0x1800, 5).start, (Position{7, 2}));  // no section of its own
    EXPECT_EQ(places.of_object(0x1A00, 1).start, (Position{16, 14}));
    EXPECT_EQ(places.of_object(0x1A00, 2).start, (Position{19, 3}));  // compact, with its own value
    EXPECT_EQ(places.of_object(0x2000, 0), diagnostic::Range{});
}

TEST(ValuePlaces, of_a_key_are_its_value_or_its_section) {
    const ValuePlaces places(text);
    using diagnostic::Position;
    EXPECT_EQ(places.of_key(SectionKind::commissioning, "baudrate").start, (Position{21, 10}));
    EXPECT_EQ(places.of_key(SectionKind::device_info, "BaudRate_125").start, (Position{2, 14}));
    EXPECT_EQ(places.of_key(SectionKind::device_info, "").start, (Position{1, 2}));
    EXPECT_EQ(places.of_key(SectionKind::tools, ""), diagnostic::Range{});
}

}  // namespace
}  // namespace cgw::eds
