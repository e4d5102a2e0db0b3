// What the writer writes, the reader reads: any dictionary, as data sheet and as configuration file.
#include <gtest/gtest.h>

#include "dictionary/node.hpp"
#include "eds/reader.hpp"
#include "eds/value_text.hpp"
#include "eds/writer.hpp"
#include "support/random_dictionary.hpp"

namespace cgw::eds {
namespace {

using dictionary::Dictionary;
using dictionary::Value;
using object::DataType;

constexpr std::uint32_t rounds = 300;

struct Again {
    Sheet sheet;
    std::string findings;
};

Again read_again(const std::string& text) {
    diagnostic::Findings findings;
    Sheet sheet = read(Document(text), "a.eds", findings);
    std::string told;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        told += std::string(finding.rule->name) + ": " + finding.message + "\n";
    }
    return {std::move(sheet), told};
}

std::string text_of(DataType type, std::uint64_t number) {
    return value_text(Value{number}, dictionary::row_of(type));
}

Value read_value(DataType type, const std::string& text) {
    const Again again =
        read_again("[2000]\nParameterName=V\nObjectType=7\nAccessType=rw\nDataType=" +
                   std::to_string(static_cast<unsigned>(type)) + "\nDefaultValue=" + text + "\n");
    EXPECT_EQ(again.findings, "");
    const dictionary::Variable* const variable = again.sheet.dictionary.find(0x2000, 0);
    return variable != nullptr ? variable->default_value : Value{};
}

}  // namespace

TEST(EdsRoundTrip, a_data_sheet_reads_back_as_it_was) {
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        const Dictionary dictionary = dictionary::without_node(test::RandomDictionary(seed).dictionary());
        const std::string text = write(dictionary);
        const Again again = read_again(text);
        ASSERT_EQ(again.findings, "") << "seed " << seed << '\n' << text;
        ASSERT_TRUE(again.sheet.dictionary == dictionary) << "seed " << seed << '\n' << text;
        ASSERT_FALSE(again.sheet.commissioning);
        ASSERT_EQ(write(again.sheet.dictionary), text);
    }
}

TEST(EdsRoundTrip, a_configuration_file_reads_back_as_it_was) {
    for (std::uint32_t seed = 0; seed < rounds; ++seed) {
        test::RandomDictionary random(seed);
        const Dictionary dictionary = random.dictionary();
        const dictionary::Commissioning node = random.commissioning();
        const std::string text = write(dictionary, node);
        const Again again = read_again(text);
        ASSERT_EQ(again.findings, "") << "seed " << seed << '\n' << text;
        ASSERT_TRUE(again.sheet.dictionary == dictionary) << "seed " << seed << '\n' << text;
        ASSERT_EQ(again.sheet.commissioning, node) << "seed " << seed;
    }
}

TEST(EdsRoundTrip, a_data_sheet_says_nothing_of_one_node) {
    const Dictionary dictionary = test::RandomDictionary(7).dictionary();
    EXPECT_EQ(write(dictionary), write(dictionary::without_node(dictionary)));
}

TEST(EdsValueText, writes_reals_so_that_importers_read_them) {
    EXPECT_EQ(text_of(DataType::real32, 0x3FC00000), "1.5");
    EXPECT_EQ(text_of(DataType::real32, 0x3DCCCCCD), "0.1");
    EXPECT_EQ(text_of(DataType::real32, 0x80000000), "-0");
    EXPECT_EQ(text_of(DataType::real32, 0x7FC00000), "0x7FC00000");  // no number
    EXPECT_EQ(text_of(DataType::real64, 0x3FB999999999999A), "0.1");
    EXPECT_EQ(text_of(DataType::real64, 0x7FF0000000000000), "0x7FF0000000000000");  // infinite
    EXPECT_EQ(read_value(DataType::real32, text_of(DataType::real32, 0x7F7FFFFF)).number, 0x7F7FFFFFU);
    EXPECT_EQ(read_value(DataType::real32, text_of(DataType::real32, 0x00000001)).number, 0x00000001U);
}

TEST(EdsValueText, writes_octets_as_pairs_of_digits) {
    EXPECT_EQ(value_text(Value{0, false, std::string("\x00\xAB\x10", 3)},
                         dictionary::row_of(DataType::octet_string)),
              "00AB10");
    EXPECT_EQ(octets_of("00 ab 10"), std::string("\x00\xAB\x10", 3));
    EXPECT_FALSE(octets_of("0"));
    EXPECT_FALSE(octets_of("0g"));
}

TEST(EdsValueText, writes_wide_numbers_in_full) {
    EXPECT_EQ(text_of(DataType::unsigned24, 0x12), "0x000012");
    EXPECT_EQ(text_of(DataType::unsigned64, ~std::uint64_t{0}), "0xFFFFFFFFFFFFFFFF");
    EXPECT_EQ(text_of(DataType::integer64, std::uint64_t{1} << 63), "-9223372036854775808");
    EXPECT_EQ(text_of(DataType::integer24, 0xFFFFFE), "-2");
    EXPECT_EQ(text_of(DataType::time_of_day, 1), "0x000000000001");
    EXPECT_EQ(text_of(DataType::identity, 1), "");
}

TEST(EdsWriter, keeps_a_string_that_an_object_holds) {
    Dictionary dictionary;
    dictionary::Object& object = dictionary.objects.emplace_back();
    object.index = 0x1008;
    dictionary::Variable& variable = object.variables.emplace_back();
    variable.type = DataType::visible_string;
    variable.default_value.bytes = std::string(300, 'x') +
                                   "; Gr\xC3\xB6\xC3\x9F"
                                   "e";
    const Again again = read_again(write(dictionary));
    EXPECT_EQ(again.sheet.dictionary.objects.front().variables.front().default_value.bytes,
              variable.default_value.bytes);
    variable.default_value.bytes = "two\r\n[2000]lines";
    const Again broken = read_again(write(dictionary));
    EXPECT_EQ(broken.sheet.dictionary.objects.front().variables.front().default_value.bytes,
              "two  [2000]lines");
    EXPECT_EQ(broken.sheet.dictionary.objects.size(), 1U);
}

}  // namespace cgw::eds
