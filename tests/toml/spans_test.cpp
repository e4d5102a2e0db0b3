// Where keys and values stand.
#include "toml/support.hpp"

namespace cgw {
namespace {

using test::at;
using test::parsed;
using test::show;
using test::slice;
using toml::Entry;
using toml::Node;

// Key range, then value range.
std::string spans(const Node& table, std::string_view key) {
    const Entry* entry = table.find(key);
    return entry == nullptr ? "absent" : show(entry->key_range) + " " + show(entry->value.range);
}

TEST(TomlSpans, a_key_is_found_left_of_its_value) {
    const Node document =
        parsed("format = 1\n  \"16404 X(0)\"=\t0x282  # 'c' = \"no\"\n'd' = [1, 2]\ne=-1.5");
    EXPECT_EQ(spans(document, "format"), "1:1-1:7 1:10-1:11");
    EXPECT_EQ(spans(document, "16404 X(0)"), "2:3-2:15 2:17-2:22");
    EXPECT_EQ(spans(document, "d"), "3:1-3:4 3:7-3:13");
    EXPECT_EQ(show(at(document, "d/1").range), "3:11-3:12");
    EXPECT_EQ(spans(document, "e"), "4:1-4:2 4:3-4:7");
}

TEST(TomlSpans, parts_of_a_dotted_key_have_their_own_ranges) {
    const Node document = parsed("a . \"b\".c = true\n");
    EXPECT_EQ(spans(document, "a"), "1:1-1:2 1:1-1:2");
    EXPECT_EQ(spans(at(document, "a"), "b"), "1:5-1:8 1:5-1:8");
    EXPECT_EQ(spans(at(document, "a/b"), "c"), "1:9-1:10 1:13-1:17");
}

TEST(TomlSpans, a_table_stands_at_its_header) {
    const Node document = parsed("x = 1\n[ governor . parameters ] # y\n401 = 1\n[governor]\nz = 2\n");
    EXPECT_EQ(spans(document, "governor"), "4:2-4:10 4:1-4:11");
    EXPECT_EQ(spans(at(document, "governor"), "parameters"), "2:14-2:24 2:1-2:26");
    EXPECT_EQ(spans(at(document, "governor/parameters"), "401"), "3:1-3:4 3:7-3:8");
}

TEST(TomlSpans, an_implied_table_stands_at_the_header_that_implies_it) {
    const Node document = parsed("\n[gateway.parameters]\n");
    EXPECT_EQ(spans(document, "gateway"), "2:2-2:9 2:1-2:21");
}

TEST(TomlSpans, elements_of_a_list_of_tables_stand_at_their_headers) {
    const Node document = parsed("[[g.declare]]\nnumber = 1\n  [[g.declare]]\nnumber = 2\n");
    EXPECT_EQ(spans(at(document, "g"), "declare"), "1:5-1:12 1:1-1:14");
    EXPECT_EQ(show(at(document, "g/declare/0").range), "1:1-1:14");
    EXPECT_EQ(show(at(document, "g/declare/1").range), "3:3-3:16");
    EXPECT_EQ(spans(at(document, "g/declare/1"), "number"), "4:1-4:7 4:10-4:11");
}

TEST(TomlSpans, keys_inside_lists_of_inline_tables) {
    const Node document = parsed("a = [ {x = 1, y.z = '='}, # {q = 1}\n  {\"k }\" = {}, l = [\n3]} ]\n");
    EXPECT_EQ(spans(at(document, "a/0"), "x"), "1:8-1:9 1:12-1:13");
    EXPECT_EQ(spans(at(document, "a/0/y"), "z"), "1:17-1:18 1:21-1:24");
    EXPECT_EQ(show(at(document, "a/0").range), "1:7-1:25");
    EXPECT_EQ(spans(at(document, "a/1"), "k }"), "2:4-2:9 2:12-2:14");
    EXPECT_EQ(spans(at(document, "a/1"), "l"), "2:16-2:17 2:20-3:3");
    EXPECT_EQ(show(at(document, "a/1/l/0").range), "3:1-3:2");
    EXPECT_EQ(show(at(document, "a").range), "1:5-3:6");
}

TEST(TomlSpans, multi_line_strings_do_not_shift_what_follows) {
    const Node document = parsed("a = \"\"\"x = 1\n[y]\n# \\\n\n \"\"\" # c\nb = '''\n''' \nc = 1\n");
    EXPECT_EQ(spans(document, "a"), "1:1-1:2 1:5-5:5");
    EXPECT_EQ(spans(document, "b"), "6:1-6:2 6:5-7:4");
    EXPECT_EQ(spans(document, "c"), "8:1-8:2 8:5-8:6");
}

TEST(TomlSpans, line_ends_may_be_crlf) {
    const Node document =
        parsed("a = 1\r\n[t]\r\n# c\r\nb = [\r\n  2,\r\n]\r\nd = \"\"\"\r\nx\r\n\"\"\"\r\n");
    EXPECT_EQ(spans(document, "a"), "1:1-1:2 1:5-1:6");
    EXPECT_EQ(spans(document, "t"), "2:2-2:3 2:1-2:4");
    EXPECT_EQ(spans(at(document, "t"), "b"), "4:1-4:2 4:5-6:2");
    EXPECT_EQ(show(at(document, "t/b/0").range), "5:3-5:4");
    EXPECT_EQ(spans(at(document, "t"), "d"), "7:1-7:2 7:5-9:4");
    EXPECT_EQ(at(document, "t/d").text, "x\r\n");
}

TEST(TomlSpans, columns_count_bytes) {
    const Node document =
        parsed("\"\xC3\xA4\" = \"\xE2\x82\xAC\" # \xF0\x9F\x98\x80\n\tb\t=\t1\nc = [\"\xC3\xBC\", 2]\n");
    EXPECT_EQ(spans(document, "\xC3\xA4"), "1:1-1:5 1:8-1:13");
    EXPECT_EQ(spans(document, "b"), "2:2-2:3 2:6-2:7");
    EXPECT_EQ(show(at(document, "c/1").range), "3:12-3:13");
}

TEST(TomlSpans, a_byte_order_mark_counts_as_bytes_of_the_first_line) {
    const Node document = parsed(
        "\xEF\xBB\xBF"
        "a = 1\nb = 2\n");
    EXPECT_EQ(spans(document, "a"), "1:4-1:5 1:8-1:9");
    EXPECT_EQ(spans(document, "b"), "2:1-2:2 2:5-2:6");
}

TEST(TomlSpans, the_last_line_needs_no_line_end) {
    const std::string text = "a = 12";
    const Node document = parsed(text);
    EXPECT_EQ(slice(text, at(document, "a").range), "12");
}

}  // namespace
}  // namespace cgw
