#include "convert/formats.hpp"

#include <gtest/gtest.h>

#include "convert/unread.hpp"
#include "eds/reader.hpp"
#include "support/golden.hpp"
#include "xdd/reader.hpp"

namespace cgw::convert {
namespace {

Description io_device() {
    diagnostic::Findings findings;
    eds::Sheet sheet = eds::read(eds::Document(test::read_text(CGW_TEST_DATA "/convert/io-device.eds")),
                                 "io-device.eds", findings);
    EXPECT_TRUE(findings.all().empty());
    return {std::move(sheet.dictionary), std::move(sheet.commissioning)};
}

std::string converted(const Description& description, std::string_view format,
                      std::optional<std::uint8_t> node_id = std::nullopt) {
    const auto product = convert(description, {.format = *find_format(format), .node_id = node_id});
    return product ? std::string(product->bytes.begin(), product->bytes.end()) : product.error().message;
}

}  // namespace

TEST(ConvertFormats, are_found_by_name_and_by_the_ending_of_a_file) {
    EXPECT_EQ(find_format("html"), nullptr);
    EXPECT_EQ(format_of_file("plant"), nullptr);
    EXPECT_EQ(format_of_file(".eds"), nullptr);
    for (const Format& format : formats()) {
        EXPECT_EQ(find_format(format.name), &format);
        EXPECT_EQ(format_of_file("a" + std::string(format.ending)), &format);
    }
    EXPECT_EQ(format_of_file("A.XDD"), find_format("xdd"));
}

TEST(ConvertFormats, write_what_they_always_wrote) {
    const Description device = io_device();
    for (const std::string format : {"eds", "xdd", "json", "md", "csv"}) {
        test::expect_golden("convert/golden/io-device." + format, converted(device, format));
    }
    for (const std::string format : {"dcf", "xdc"}) {
        test::expect_golden("convert/golden/io-device-5." + format, converted(device, format, 5));
    }
}

TEST(ConvertFormats, of_one_node_need_its_number) {
    const Description device = io_device();
    EXPECT_EQ(converted(device, "dcf"),
              "--node-id is needed: dcf is about one node, and the file does not say which");
    EXPECT_EQ(converted(device, "concise-dcf", 5),
              "the file says of no node which values it has; a concise DCF is made of a DCF or XDC");
    Description node = device;
    node.node.emplace().node_id = 7;
    EXPECT_EQ(converted(node, "xdc", 5), "the file is about node 7; leave --node-id out");
    EXPECT_NE(converted(node, "xdc", 7).find("NodeID=\"7\""), std::string::npos);
    node.node->node_id = 0;
    EXPECT_EQ(converted(node, "xdc"), "--node-id is needed: the file leaves the node number open");
    EXPECT_NE(converted(node, "xdc", 9).find("NodeID=\"9\""), std::string::npos);
}

TEST(ConvertFormats, tell_what_is_lost_and_resolved) {
    const Description device = io_device();
    const auto xdd = convert(device, {.format = *find_format("xdd")});
    ASSERT_EQ(xdd->losses.size(), 1U);
    EXPECT_EQ(xdd->losses[0].row->text, "links between objects (ObjectLinks)");
    EXPECT_EQ(xdd->losses[0].count, 1U);
    const auto dcf = convert(device, {.format = *find_format("dcf"), .node_id = 5});
    EXPECT_TRUE(dcf->losses.empty());
    EXPECT_EQ(dcf->resolved, 3U);
    EXPECT_EQ(dcf->node_id, 5);
}

TEST(ConvertFormats, give_the_product_its_own_name) {
    const auto product = convert(io_device(), {.format = *find_format("eds"), .file_name = "other.eds"});
    const std::string text(product->bytes.begin(), product->bytes.end());
    EXPECT_NE(text.find("FileName=other.eds\r\n"), std::string::npos);
}

TEST(ConvertFormats, make_a_concise_dcf_of_the_values_of_a_node) {
    Description node = io_device();
    node.node.emplace().node_id = 5;
    EXPECT_EQ(converted(node, "concise-dcf"), std::string(4, '\0'));
    for (dictionary::Object& object : node.dictionary.objects) {
        if (object.index == 0x1017) {
            object.variables.front().parameter_value = dictionary::Value{1000};
        }
    }
    EXPECT_EQ(converted(node, "concise-dcf"), std::string("\1\0\0\0\x17\x10\0\2\0\0\0\xE8\3", 13));
}

TEST(SectionsNotRead, are_those_that_mean_nothing_to_cgw) {
    EXPECT_EQ(sections_not_read("[FileInfo]\n[Tools]\n[1000]\n[1018sub1]\n[Vendor\x1B]\n[DynamicChannels]\n"),
              (std::vector<std::string>{"[Tools]", "[Vendor?]", "[DynamicChannels]"}));
    EXPECT_TRUE(sections_not_read("").empty());
}

}  // namespace cgw::convert
