// Questions and answers about objects.
#include "explain/answers.hpp"

#include <fmt/format.h>

#include "catalogue/objects.hpp"

namespace cgw::explain {
namespace {

TEST_F(Explain, an_object_has_type_source_and_bits) {
    EXPECT_EQ(titles("1018h"), "object 1018h Identity Object");
    EXPECT_EQ(field("1018h", "entries"),
              "0 Number of entries, 1 Vendor ID, 2 Product Code, 3 Revision Number, 4 Serial Number");
    EXPECT_EQ(field("0x1018:2", "value"), "7001 (0x1B59)");
    EXPECT_EQ(field("1018h:3", "comes from"), "gateway 3842");
    EXPECT_EQ(titles("2003h:1"), "object 2003h:1 Digital Inputs, Switch Functions");
    EXPECT_EQ(field("2003h:1", "type"), "UNSIGNED16, read by SDO, written by RPDO only");
    EXPECT_EQ(titles("2000h07"), "object 2000h:7 Digital Outputs, Engine State");
    EXPECT_EQ(field("2005h", "type"), "UNSIGNED16, read by SDO, cannot be written");
    EXPECT_EQ(field("2001h:52", "type"), "UNSIGNED16, read by SDO, cannot be written");
    EXPECT_EQ(field("2002h:1", "type"), "INTEGER16, read by SDO, cannot be written");
    EXPECT_EQ(field("1804h:1", "comes from").substr(0, 13), "gateway 16404");
    EXPECT_EQ(titles("2004h:0"), "object 2004h:0 Analog Inputs");
}

TEST_F(Explain, every_described_object_exists_and_every_object_is_described) {
    for (const catalogue::ObjectDescription& object : catalogue::shipped_objects()) {
        const std::string name =
            fmt::format("0x{:04X}{}", object.index, object.whole ? "" : fmt::format(":{}", object.last_sub));
        EXPECT_TRUE(ask(name).understood()) << name;
    }
    constexpr unsigned blocks[] = {0x1000, 0x1010, 0x1200, 0x1280, 0x1400, 0x1600, 0x1800, 0x1A00, 0x2000};
    for (const unsigned block : blocks) {
        for (unsigned index = block; index < block + 0x10; ++index) {
            const bool described = catalogue::find_object(static_cast<std::uint16_t>(index)) != nullptr;
            EXPECT_EQ(ask(fmt::format("0x{:04X}", index)).understood(), described) << index;
        }
    }
}

TEST_F(Explain, an_object_that_is_not_there_is_refused) {
    EXPECT_EQ(
        complaint("1010h"),  // D42
        "the gateway has no object 1010h | a number of four decimal digits without 0x or h is a parameter");
    EXPECT_EQ(complaint("1018h:5"), "the gateway has no object 1018h:5");
    EXPECT_EQ(complaint("2001h:53"), "the gateway has no object 2001h:53");
}

}  // namespace
}  // namespace cgw::explain
