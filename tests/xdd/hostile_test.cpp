// Texts that nobody should write.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "diagnostic/rules/xdd.hpp"
#include "support/random_dictionary.hpp"
#include "xdd/reading_result.hpp"
#include "xdd/writer.hpp"

namespace cgw::xdd {
namespace {

using Result = test::XddResult;

}  // namespace

TEST(HostileXdd, of_another_kind_is_refused) {
    using namespace std::string_literals;
    for (const std::string& text : {""s, "\x89PNG\r\n"s, "\xFF\xFE<\0a\0"s, "<a>\0</a>"s, "<a>"s, "<a></b>"s,
                                    "<a/><b/>"s, "<!-- -->"s, "<?xml version=\"1.0\"?>"s, "<a b=\"1></a>"s}) {
        EXPECT_EQ(Result(text).findings.all().size(), 1U) << text;
        EXPECT_EQ(Result(text).findings.all().front().rule, &diagnostic::rules::xdd_text) << text;
    }
    const Result result("<a>\n  <b></a>");
    EXPECT_EQ(result.findings.all().front().where.range.start.line, 2U);
}

TEST(HostileXdd, is_no_xml_for_other_readers_and_for_this_one) {
    const auto told = [](const std::string& attributes, const std::string& around = "") {
        const Result result("<?xml version=\"1.0\"?>\n<a>\n <b" + attributes + "/>\n</a>\n" + around);
        EXPECT_EQ(result.findings.all().size(), 1U) << attributes << around;
        const diagnostic::Diagnostic& finding = result.findings.all().front();
        const diagnostic::Position& at = finding.where.range.start;
        return finding.rule == &diagnostic::rules::xdd_text
                   ? fmt::format("{}:{} {}", at.line, at.column,
                                 finding.message.substr(finding.message.find(": ") + 2))
                   : "";
    };
    EXPECT_EQ(told(" c='1' d=\"2\""), "");
    EXPECT_EQ(told(" c = '&lt;&#65;&#x41;&quot;' ", "<!-- - -->\n<?p i?>"), "");
    EXPECT_EQ(told(" c='a&#0;b'"), "3:9 `&#0` begins no reference to a character");
    EXPECT_EQ(told(" c='&#x110000;'"), "3:8 `&#x110000` begins no reference to a character");
    EXPECT_EQ(told(" c='&#;'"), "3:8 `&#` begins no reference to a character");
    EXPECT_EQ(told(" c='&nbsp;'"), "3:8 `&nbsp` begins no reference to a character");
    EXPECT_EQ(told(" c='&'"), "3:8 `&` begins no reference to a character");
    EXPECT_EQ(told(" c='1' c='2'"), "3:2 the attribute c stands twice in one element");
    EXPECT_EQ(told(" c='1'd='2'"), "3:10 error parsing element attribute");
    EXPECT_EQ(told(" c='i<n'"), "3:9 `<` stands in the value of an attribute");
    EXPECT_EQ(told("", "junk"), "5:1 text stands outside of the root element");
    EXPECT_EQ(told("", "<![CDATA[]]>"), "5:1 text stands outside of the root element");
    EXPECT_EQ(told("", "<!-- a -- b -->"), "5:8 two hyphens stand in a comment");
    EXPECT_EQ(told(" c='\x01'"), "3:8 a control character 0x01 stands in it");
    EXPECT_EQ(told("/>&copy;<b"), "3:6 `&copy` begins no reference to a character");
}

TEST(HostileXdd, is_looked_through_once) {
    std::string text = "<a";
    for (int i = 0; i < 100'000; ++i) {
        text += fmt::format(" a{}='&amp;'", i);
    }
    EXPECT_EQ(Result(text + ">" + std::string(1'000'000, ';') + "</a>").told(), "1:2 xdd-root\n");
}

TEST(HostileXdd, declares_no_entities) {
    const Result result(
        "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/hostname\">"
        "<!ENTITY y \"&x;&x;&x;\">]><a>&y;</a>");
    EXPECT_EQ(result.told(), "0:0 xdd-text\n");
}

TEST(HostileXdd, may_be_as_deep_as_it_likes) {
    std::string text;
    for (int i = 0; i < 200'000; ++i) {
        text += "<a>";
    }
    EXPECT_FALSE(Result(text).findings.all().empty());
    for (int i = 0; i < 200'000; ++i) {
        text += "</a>";
    }
    EXPECT_EQ(Result(text).told(), "1:2 xdd-root\n");
}

TEST(HostileXdd, is_not_read_beyond_the_largest_text) {
    const Result result(std::string(largest_text + 1, ' '));
    EXPECT_EQ(result.message(), "the file has more than 32 MiB");
}

TEST(HostileXdd, has_findings_counted_beyond_the_first_hundred_of_a_kind) {
    std::string objects;
    for (int i = 0; i < 1000; ++i) {
        objects += "<CANopenObject/>";
    }
    const Result result(test::device_description("", objects));
    ASSERT_EQ(result.findings.all().size(), most_findings + 1);
    EXPECT_EQ(result.findings.all().front().message,
              "900 more findings of this kind are not told one by one");
}

// As many objects as there can be, and one long parameter, template and type for all of them.
TEST(HostileXdd, may_refer_to_one_long_parameter_from_everywhere) {
    std::string objects;
    for (int i = 0x1000; i < 0x5000; ++i) {
        objects += fmt::format("<CANopenObject index=\"{:X}\" objectType=\"7\" uniqueIDRef=\"P\"/>\n", i);
    }
    const Result result(test::device_description("<parameter uniqueID=\"P\" access=\"read\"><description>" +
                                                     std::string(400'000, 'x') +
                                                     "</description><UINT/></parameter>\n",
                                                 objects));
    EXPECT_TRUE(result.findings.has_errors());
    EXPECT_FALSE(result.sheet.dictionary.objects.empty());
}

TEST(HostileXdd, may_refer_to_one_short_parameter_from_everywhere) {
    std::string objects;
    for (int i = 0x1000; i < 0x10000; ++i) {
        objects += fmt::format("<CANopenObject index=\"{:X}\" objectType=\"7\" uniqueIDRef=\"P\"/>\n", i);
    }
    const Result result(test::device_description(
        "<parameter uniqueID=\"P\" access=\"read\"><label lang=\"en\">V</label><UINT/></parameter>\n",
        objects));
    EXPECT_EQ(result.told(), "");
    EXPECT_EQ(result.sheet.dictionary.objects.size(), 0xF000U);
}

TEST(HostileXdd, in_latin_1_has_its_findings_where_they_stand_in_the_file) {
    const Result result(test::device_description(
        "", "<CANopenObject index=\"2000\" name=\"Gr\xF6\xDF\x65\" dataType=\"0005\" accessType=\"x\"/>"));
    EXPECT_EQ(result.told(), "3:70 xdd-access\n");
}

TEST(HostileXdd, may_be_any_bytes) {
    const std::string sound =
        write(test::RandomDictionary(3).dictionary(), test::RandomDictionary(3).commissioning());
    test::RandomDictionary random(1);
    for (int round = 0; round < 150; ++round) {
        std::string text = sound;
        for (std::uint32_t changes = 1 + random.below(6); changes > 0; --changes) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
            switch (random.below(4)) {
                case 0:
                    text[at] = static_cast<char>(random.below(256));
                    break;
                case 1:
                    text.erase(at, random.below(40));
                    break;
                case 2:
                    text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())),
                                                random.below(60)));
                    break;
                default:
                    text.insert(at, "\"");
            }
        }
        const Result result(text);
        const auto lines = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) + 1;
        for (const diagnostic::Diagnostic& finding : result.findings.all()) {
            ASSERT_LE(finding.where.range.start.line, lines);
        }
    }
}

}  // namespace cgw::xdd
