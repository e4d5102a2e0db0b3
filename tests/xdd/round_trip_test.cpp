// What the writer writes, the reader reads: any dictionary, but for what CiA 311 has no place for.
#include <gtest/gtest.h>

#include "dictionary/node.hpp"
#include "profile/gateway.hpp"
#include "support/random_dictionary.hpp"
#include "support/sample_configuration.hpp"
#include "xdd/reading_result.hpp"
#include "xdd/writer.hpp"

namespace cgw::xdd {
namespace {

using dictionary::Commissioning;
using dictionary::Dictionary;

constexpr std::uint32_t rounds = 100;

Dictionary held(Dictionary dictionary) {
    std::erase_if(dictionary.supported_dummies, [](std::uint8_t type) { return type > 7; });
    dictionary.modules.clear();
    for (dictionary::Object& object : dictionary.objects) {
        object.object_links.clear();
        for (dictionary::Variable& variable : object.variables) {
            variable.run_time = false;
            variable.upload_file.clear();
            variable.download_file.clear();
            if (!has_sub_objects(object.code)) {
                variable.name = object.name;
            }
        }
    }
    return dictionary;
}

Commissioning held(Commissioning node) {
    node.last_eds.clear();
    node.serial_number = 0;
    node.connected_modules.clear();
    return node;
}

}  // namespace

TEST(XddRoundTrip, a_device_description_reads_back_as_it_was) {
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        const Dictionary dictionary =
            held(dictionary::without_node(test::RandomDictionary(seed).dictionary()));
        const std::string text = write(dictionary);
        const test::XddResult again(text);
        ASSERT_EQ(again.told(), "") << "seed " << seed << '\n' << text;
        ASSERT_TRUE(again.sheet.dictionary == dictionary) << "seed " << seed << '\n' << text;
        ASSERT_FALSE(again.sheet.commissioning);
    }
}

TEST(XddRoundTrip, a_configuration_reads_back_as_it_was) {
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        test::RandomDictionary random(seed);
        const Dictionary dictionary = held(random.dictionary());
        const Commissioning node = held(random.commissioning());
        const std::string text = write(dictionary, node);
        const test::XddResult again(text);
        ASSERT_EQ(again.told(), "") << "seed " << seed << '\n' << text;
        ASSERT_TRUE(again.sheet.dictionary == dictionary) << "seed " << seed << '\n' << text;
        ASSERT_EQ(again.sheet.commissioning, node) << "seed " << seed;
    }
}

TEST(XddRoundTrip, the_gateway_reads_back_as_it_was) {
    profile::GatewayDocument document;
    document.tool_version = "0.1.0";
    for (const Dictionary& dictionary : {profile::gateway_dictionary(test::manual_configuration(), document),
                                         profile::generic_gateway_dictionary(document)}) {
        const test::XddResult again(write(dictionary));
        EXPECT_EQ(again.told(), "");
        EXPECT_TRUE(again.sheet.dictionary == held(dictionary)) << write(again.sheet.dictionary);
    }
}

TEST(XddWriter, writes_texts_as_xml_can_carry_them) {
    Dictionary dictionary;
    dictionary.file.description = "a & b <c> \"d\"\ttab \x01 Gr\xC3\xB6\xC3\x9F\x65";
    dictionary.device.vendor_name = "Gr\xF6\xDF\x65";  // Latin-1
    dictionary.comments = {"", "x"};
    const test::XddResult again(write(dictionary));
    EXPECT_EQ(again.told(), "");
    EXPECT_EQ(again.sheet.dictionary.file.description, "a & b <c> \"d\"\ttab ? Gr\xC3\xB6\xC3\x9F\x65");
    EXPECT_EQ(again.sheet.dictionary.device.vendor_name, "Gr\xC3\xB6\xC3\x9F\x65");
    EXPECT_EQ(again.sheet.dictionary.comments, dictionary.comments);
}

TEST(XddWriter, keeps_a_string_of_several_lines) {
    Dictionary dictionary;
    dictionary::Object& object = dictionary.objects.emplace_back();
    object.index = 0x1008;
    object.variables.emplace_back().type = object::DataType::visible_string;
    object.variables.front().default_value.bytes = "two\r\nlines\t.";
    const test::XddResult again(write(dictionary));
    EXPECT_EQ(again.variable(0x1008).default_value.bytes, "two\r\nlines\t.");
}

TEST(XddWriter, stays_in_the_name_space_of_version_1_1) {
    const std::string text = write(profile::generic_gateway_dictionary({}));
    for (const std::string_view part :
         {"<ISO15745ProfileContainer xmlns=\"http://www.canopen.org/xml/1.1\"", "<ProfileHeader xmlns=\"\">",
          "xsi:type=\"co:ProfileBody_CommunicationNetwork_CANopen\"", "<co:CANopenObjectList ",
          "<CANopenObject index=\"1000\""}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

}  // namespace cgw::xdd
