// What the reader passes over is counted, and nothing of what cgw writes is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/random_dictionary.hpp"
#include "xdd/reading_result.hpp"
#include "xdd/writer.hpp"

namespace cgw::xdd {
namespace {

std::string unread_of(std::string_view text) {
    std::string told;
    for (const Unread& each : test::XddResult(text).sheet.unread) {
        told += fmt::format("{} {}\n", each.what, each.count);
    }
    return told;
}

}  // namespace

TEST(XddUnread, counts_what_it_passes_over) {
    EXPECT_EQ(unread_of(test::device_description(
                  "<!-- by hand -->"
                  "<parameter uniqueID=\"P\" access=\"read\" support=\"optional\" persistent=\"false\">"
                  "<label lang=\"en\">V</label><label lang=\"de\">W</label><description lang=\"en\">d"
                  "</description><UINT/><defaultValue value=\"1\"/><unit multiplier=\"1\"/><allowedValues>"
                  "<value value=\"1\"/><value value=\"2\"/></allowedValues><property name=\"n\" "
                  "value=\"v\"/><property name=\"n\" value=\"v\"/></parameter>",
                  "<CANopenObject index=\"2000\" name=\"V\" objectType=\"7\" uniqueIDRef=\"P\" "
                  "vendor:Note=\"x\"/>",
                  "<TransportLayers><PhysicalLayer><baudRate defaultValue=\"250 Kbps\"><supportedBaudRate "
                  "value=\"250 Kbps\"/></baudRate></PhysicalLayer></TransportLayers>"
                  "<NetworkManagement><CANopenGeneralFeatures granularity=\"8\" ngSlave=\"true\" "
                  "timestampMessage=\"false\"/></NetworkManagement>")),
              "element allowedValues 1\nelement description 1\nelement label 1\nelement property 2\n"
              "element unit 1\nattribute defaultValue 1\nattribute ngSlave 1\nattribute support 1\n"
              "attribute vendor:Note 1\ncomments 1\n");
}

TEST(XddUnread, counts_nothing_in_what_cgw_writes) {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        test::RandomDictionary random(seed);
        EXPECT_EQ(unread_of(write(random.dictionary())), "");
        EXPECT_EQ(unread_of(write(random.dictionary(), random.commissioning())), "");
    }
}

// The revision is that of the first firmware; other versions say nothing to a data sheet.
TEST(XddUnread, counts_every_version_but_the_first_firmware) {
    std::string text = test::device_description("",
                                                "<CANopenObject index=\"2000\" name=\"V\" objectType=\"7\" "
                                                "dataType=\"0007\" accessType=\"ro\"/>");
    text.insert(text.find("<ApplicationProcess>"),
                "<DeviceIdentity><version versionType=\"HW\">3</version>"
                "<version versionType=\"FW\">1</version>"
                "<version versionType=\"FW\">2</version></DeviceIdentity>");
    EXPECT_EQ(unread_of(text), "element version 2\n");
}

// Each element is looked at once, whatever stands before it.
TEST(XddUnread, counts_many_in_one_element_in_linear_time) {
    std::string many;
    for (int i = 0; i < 60000; ++i) {
        many += "<a/>";
    }
    for (int i = 0; i < 60000; ++i) {
        many += "<label/>";
    }
    EXPECT_EQ(unread_of(test::device_description("<parameter uniqueID=\"P\">" + many + "</parameter>", "")),
              "element a 60000\nelement label 59999\n");
}

TEST(XddUnread, counts_in_any_depth) {
    std::string text = "<ISO15745ProfileContainer>";
    for (int i = 0; i < 100000; ++i) {
        text += "<ProfileBody>";
    }
    for (int i = 0; i < 100000; ++i) {
        text += "</ProfileBody>";
    }
    const test::XddResult result(text + "</ISO15745ProfileContainer>");
    EXPECT_TRUE(result.findings.has_errors());
}

}  // namespace cgw::xdd
