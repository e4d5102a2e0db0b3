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
    return product ? std::string(product->bytes.begin(), product->bytes.end()) : product.error().why;
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
    EXPECT_EQ(converted(device, "concise-dcf"),
              "--node-id is needed: concise-dcf is about one node, and the file does not say which");
    EXPECT_EQ(converted(device, "concise-dcf", 5), std::string(4, '\0'));
    EXPECT_TRUE(convert(device, {.format = *find_format("concise-dcf"), .node_id = 5})->no_entries);
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

// Latin-1 becomes UTF-8 once: not when it is read and again when it is written, and UTF-8 stays as it is.
TEST(ConvertFormats, decode_latin_1_once) {
    const std::string sheet = "[FileInfo]\n[DeviceInfo]\nProductName=";
    for (const std::string_view name : {"Ger\xE4t", "Ger\xC3\xA4t"}) {
        diagnostic::Findings findings;
        const eds::Document document(sheet + std::string(name) + "\n");
        const Description device{eds::read(document, "device.eds", findings).dictionary, {}};
        for (const std::string_view format : {"xdd", "json", "md"}) {
            EXPECT_NE(converted(device, format).find("Ger\xC3\xA4t"), std::string::npos) << format;
        }
        const xdd::Sheet again = xdd::read(converted(device, "xdd"), "device.xdd", findings);
        EXPECT_NE(converted(device, "eds").find("ProductName=Geraet\r\n"), std::string::npos);
        EXPECT_EQ(again.dictionary.device.product_name, "Ger\xC3\xA4t");
        EXPECT_NE(converted({again.dictionary, {}}, "eds").find("ProductName=Geraet\r\n"), std::string::npos)
            << converted({again.dictionary, {}}, "eds");
    }
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

TEST(ConvertFormats, refuse_a_node_number_that_has_no_use) {
    for (const std::string format : {"eds", "xdd", "json", "md", "csv"}) {
        EXPECT_EQ(converted(io_device(), format, 5),
                  "--node-id is for formats that are about one node, dcf, xdc and concise-dcf; " + format +
                      " keeps $NODEID as it stands");
    }
}

TEST(ConvertFormats, refuse_a_formula_that_makes_too_large_a_number) {
    const struct {
        object::DataType type;
        std::uint64_t number;
        bool fits;
    } cases[] = {
        {object::DataType::unsigned32, 0xFFFFFFF0, true},
        {object::DataType::unsigned32, 0xFFFFFFF1, false},
        {object::DataType::unsigned8, 0xF0, true},
        {object::DataType::unsigned8, 0xF1, false},
        {object::DataType::unsigned16, 0xFFF1, false},
        {object::DataType::boolean, 1, false},
        {object::DataType::unsigned64, ~std::uint64_t{15}, true},
        {object::DataType::unsigned64, ~std::uint64_t{14}, false},
    };
    for (const auto& each : cases) {
        Description device = io_device();
        dictionary::Object& object = device.dictionary.objects.front();
        object.variables.front().type = each.type;
        object.variables.front().default_value = {each.number, true};
        object.variables.front().low_limit.reset();
        object.variables.front().high_limit.reset();
        const std::string made = converted(device, "dcf", 15);
        EXPECT_EQ(made.find("too large a number") == std::string::npos, each.fits) << each.number << made;
        Description node = io_device();
        node.node.emplace().node_id = 15;
        node.dictionary.objects.front().variables.front().type = each.type;
        node.dictionary.objects.front().variables.front().parameter_value = {each.number, true};
        EXPECT_EQ(converted(node, "concise-dcf").find("too large a number") == std::string::npos, each.fits);
    }
}

namespace {

std::string told(const std::vector<Unread>& unread) {
    std::string text;
    for (const Unread& each : unread) {
        text += each.what + " " + std::to_string(each.count) + "\n";
    }
    return text;
}

}  // namespace

TEST(PassedOver, are_sections_that_say_nothing_of_objects) {
    const PassedOver found = passed_over_in(
        "[FileInfo]\n[Tools]\n[1000]\n[1018sub1]\n[Vendor\x1B]\n[DynamicChannels]\nA=1\n;c\n\n b = 2 "
        "\n[tools]\n");
    EXPECT_EQ(told(unread_of(found.sections)), "[Tools] 2\n[Vendor?] 1\n[DynamicChannels] 1\n");
    EXPECT_EQ(found.sections.at(2).lines, (std::vector<std::string>{"A=1", " b = 2 "}));
    EXPECT_TRUE(passed_over_in("").sections.empty());
}

TEST(PassedOver, are_unknown_keys_and_comments_counted) {
    EXPECT_EQ(told(passed_over_in("; by hand\n[FileInfo]\nFileName=a\nAuthor=b\n[1000]\nParameterName=T\n"
                                  "Unit=V\n;x\n[1018sub1]\nunit=A\nFactor=2\nDataType=7\n[Vendor]\nUnit=1\n"
                                  "[OptionalObjects]\n1=0x1000\n[DummyUsage]\nDummy0001=1\n")
                       .unread),
              "key Author 1\nkey Unit 2\nkey Factor 1\nlines of comment 2\n");
}

TEST(FurtherSections, are_in_every_eds_and_dcf_and_told_of_other_formats) {
    Description device = io_device();
    device.sections = {{"Tools", {"Items=1"}},
                       {"DynamicChannels", {"NrOfSeg=1", "Type1=0x0007", "Range1=0xA080-0xA0BF"}}};
    const std::string sections =
        "\r\n[Tools]\r\nItems=1\r\n\r\n[DynamicChannels]\r\nNrOfSeg=1\r\nType1=0x0007\r\nRange1=0xA080-"
        "0xA0BF\r\n";
    for (const Format& format : formats()) {
        const bool is_node = format.about == Format::About::node;
        if (format.name == "concise-dcf") {
            device.node.emplace().node_id = 5;
        }
        const auto product = convert(
            device, {.format = format,
                     .node_id = is_node && !device.node ? std::optional<std::uint8_t>(5) : std::nullopt});
        ASSERT_TRUE(product.has_value()) << format.name << product.error().why;
        const bool holds = format.name == "eds" || format.name == "dcf";
        EXPECT_EQ(std::string(product->bytes.begin(), product->bytes.end()).ends_with(sections), holds)
            << format.name;
        EXPECT_EQ(told(product->lost_sections), holds ? "" : "[Tools] 1\n[DynamicChannels] 1\n")
            << format.name;
        device.node.reset();
    }
}

}  // namespace cgw::convert
