// Values: what a text means.
#include "toml/document.hpp"

#include <cmath>
#include <limits>

#include "toml/support.hpp"

namespace cgw {
namespace {

using test::at;
using test::findings_of;
using test::parsed;
using toml::Kind;
using toml::Node;
using toml::Notation;

TEST(TomlValues, empty_input_is_an_empty_document) {
    for (const char* text : {"", "\n", "# only a comment", "  \t ", "\xEF\xBB\xBF", "\xEF\xBB\xBF\r\n"}) {
        const Node document = parsed(text);
        EXPECT_EQ(document.kind, Kind::table) << text;
        EXPECT_TRUE(document.entries.empty()) << text;
    }
}

TEST(TomlValues, integers_keep_notation_and_text) {
    const Node document = parsed("a = 0x02_82\nb = -1_000\nc = 0o17\nd = 0b101\ne = +7\nf = 0\n");
    EXPECT_EQ(at(document, "a").integer, 0x282);
    EXPECT_EQ(at(document, "a").real, 642.0);
    EXPECT_EQ(at(document, "a").notation, Notation::hexadecimal);
    EXPECT_EQ(at(document, "a").text, "0x02_82");
    EXPECT_EQ(at(document, "b").integer, -1000);
    EXPECT_EQ(at(document, "b").notation, Notation::decimal);
    EXPECT_EQ(at(document, "c").integer, 15);
    EXPECT_EQ(at(document, "c").notation, Notation::octal);
    EXPECT_EQ(at(document, "d").integer, 5);
    EXPECT_EQ(at(document, "d").notation, Notation::binary);
    EXPECT_EQ(at(document, "e").integer, 7);
    EXPECT_EQ(at(document, "f").integer, 0);
}

TEST(TomlValues, the_ends_of_64_bits_are_read_exactly) {
    const Node document = parsed(
        "a = 9223372036854775807\nb = -9223372036854775808\nc = 0x7fffffffffffffff\n"
        "d = 0b111111111111111111111111111111111111111111111111111111111111111\n"
        "e = 0b00000000000000000000000000000000000000000000000000000000000000000000000000000001\n"
        "f = 0o777777777777777777777\n");
    constexpr auto largest = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(at(document, "a").integer, largest);
    EXPECT_EQ(at(document, "b").integer, std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(at(document, "c").integer, largest);
    EXPECT_EQ(at(document, "d").integer, largest);
    EXPECT_EQ(at(document, "e").integer, 1);
    EXPECT_EQ(at(document, "f").integer, largest);
}

TEST(TomlValues, decimal_numbers_infinities_and_nan_are_real) {
    const Node document =
        parsed("a = 1.5\nb = -2e-2\nc = 6.26e+3_4\nd = -inf\ne = nan\nf = +0.0\ng = 1e06\n");
    EXPECT_EQ(at(document, "a").kind, Kind::real);
    EXPECT_EQ(at(document, "a").text, "1.5");
    EXPECT_EQ(at(document, "a").real, 1.5);
    EXPECT_EQ(at(document, "b").real, -0.02);
    EXPECT_EQ(at(document, "c").real, 6.26e34);
    EXPECT_EQ(at(document, "d").real, -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(at(document, "e").real));
    EXPECT_EQ(at(document, "f").real, 0.0);
    EXPECT_EQ(at(document, "g").real, 1e6);
}

TEST(TomlValues, dates_are_told_from_times) {
    const Node document = parsed(
        "a = 2026-03-01\nb = 2026-03-01T10:00:00Z\nc = 2026-03-01 10:00:00.5-07:00\nd = 07:32:00\n"
        "e = 2024-02-29 # leap\n");
    EXPECT_EQ(at(document, "a").kind, Kind::local_date);
    EXPECT_EQ(at(document, "a").text, "2026-03-01");
    EXPECT_EQ(at(document, "b").kind, Kind::other_time);
    EXPECT_EQ(at(document, "c").kind, Kind::other_time);
    EXPECT_EQ(at(document, "c").text, "2026-03-01 10:00:00.5-07:00");
    EXPECT_EQ(at(document, "d").kind, Kind::other_time);
    EXPECT_EQ(at(document, "e").kind, Kind::local_date);
}

TEST(TomlValues, strings_are_unescaped) {
    const Node document = parsed(
        "a = \"x\\t\\\"\\\\\\u00e4\\U0001F600\\u0416\\u20AC\"\n"
        "b = 'C:\\dir\\n'\n"
        "c = \"\"\"\none\\\n   two \"\" \\n\"\"\"\"\"\n"
        "d = '''\n'a''b'''''\n"
        "e = \"\"\n"
        "f = true\ng = false\n");
    EXPECT_EQ(at(document, "a").text, "x\t\"\\\xC3\xA4\xF0\x9F\x98\x80\xD0\x96\xE2\x82\xAC");
    EXPECT_EQ(at(document, "b").text, "C:\\dir\\n");
    EXPECT_EQ(at(document, "c").text, "onetwo \"\" \n\"\"");
    EXPECT_EQ(at(document, "d").text, "'a''b''");
    EXPECT_EQ(at(document, "e").kind, Kind::string);
    EXPECT_TRUE(at(document, "f").boolean);
    EXPECT_FALSE(at(document, "g").boolean);
}

TEST(TomlValues, entries_keep_the_order_of_the_file) {
    const Node document = parsed("z = 1\n[t]\nb = 1\na = 2\n[s]\n[t.u]\n");
    ASSERT_EQ(document.entries.size(), 3U);
    EXPECT_EQ(document.entries[0].key, "z");
    EXPECT_EQ(document.entries[1].key, "t");
    EXPECT_EQ(document.entries[2].key, "s");
    ASSERT_EQ(document.entries[1].value.entries.size(), 3U);
    EXPECT_EQ(document.entries[1].value.entries[0].key, "b");
    EXPECT_EQ(document.entries[1].value.entries[2].key, "u");
}

TEST(TomlValues, keys_are_found_exactly) {
    const Node document =
        parsed("\"16460 CanOpTPDO4-16Cyc(0)\" = 16\n'a.b' = 1\n\"\\u0061\" = 2\n\"\" = 3\n401 = 4\n");
    EXPECT_EQ(at(document, "16460 CanOpTPDO4-16Cyc(0)").integer, 16);
    EXPECT_EQ(at(document, "a.b").integer, 1);
    EXPECT_EQ(at(document, "a").integer, 2);
    EXPECT_EQ(at(document, "").integer, 3);
    EXPECT_EQ(at(document, "401").integer, 4);
    EXPECT_EQ(document.find("A"), nullptr);
}

TEST(TomlValues, dotted_keys_headers_and_inline_tables_build_the_same_tree) {
    for (const char* text :
         {"a.b.c = 1\na.b.d = 2\n", "[a.b]\nc = 1\nd = 2\n", "a = { b = { c = 1, d = 2 } }\n",
          "[a]\nb = { c = 1, d = 2 }\n", "[ a . 'b' ]\nc=1\nd=2", "a . b.c = 1\na.\"b\".d = 2"}) {
        const Node document = parsed(text);
        EXPECT_EQ(at(document, "a/b/c").integer, 1) << text;
        EXPECT_EQ(at(document, "a/b/d").integer, 2) << text;
    }
}

TEST(TomlValues, lists_of_tables_grow_and_hold_tables) {
    const Node document = parsed(
        "[governor]\nx = 1\n[[governor.declare]]\nnumber = 1\n[governor.declare.more]\ny = 2\n"
        "[[governor.declare]]\nnumber = 3\n[governor.parameters]\n401 = 1\n");
    EXPECT_EQ(at(document, "governor/declare").elements.size(), 2U);
    EXPECT_EQ(at(document, "governor/declare/0/more/y").integer, 2);
    EXPECT_EQ(at(document, "governor/declare/1/number").integer, 3);
    EXPECT_EQ(at(document, "governor/parameters/401").integer, 1);
}

TEST(TomlValues, a_table_may_follow_its_subtables) {
    const Node document = parsed("[a.b]\nx = 1\n[a]\ny = 2\n[a.c]\n");
    EXPECT_EQ(at(document, "a/b/x").integer, 1);
    EXPECT_EQ(at(document, "a/y").integer, 2);
}

TEST(TomlValues, lists_may_be_mixed_nested_commented_and_end_with_a_comma) {
    const Node document = parsed("a = [ # one\n 1, 'x', # two = ]\n [2,], {b=3}\n# last\n,]\nc = []\n");
    ASSERT_EQ(at(document, "a").elements.size(), 4U);
    EXPECT_EQ(at(document, "a/1").text, "x");
    EXPECT_EQ(at(document, "a/2/0").integer, 2);
    EXPECT_EQ(at(document, "a/3/b").integer, 3);
    EXPECT_EQ(at(document, "c").kind, Kind::array);
    EXPECT_TRUE(at(document, "c").elements.empty());
}

TEST(TomlValues, every_kind_has_a_name_for_messages) {
    EXPECT_EQ(toml::to_text(Kind::string), "a string");
    EXPECT_EQ(toml::to_text(Kind::integer), "an integer");
    EXPECT_EQ(toml::to_text(Kind::real), "a decimal number");
    EXPECT_EQ(toml::to_text(Kind::boolean), "a boolean");
    EXPECT_EQ(toml::to_text(Kind::local_date), "a date");
    EXPECT_EQ(toml::to_text(Kind::other_time), "a date with time");
    EXPECT_EQ(toml::to_text(Kind::array), "a list");
    EXPECT_EQ(toml::to_text(Kind::table), "a table");
}

}  // namespace
}  // namespace cgw
