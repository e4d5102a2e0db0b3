// The document layer: what it makes of lines, where each part stands, and that nothing is lost.
#include "eds/document.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "eds/random_text.hpp"
#include "support/golden.hpp"

namespace cgw::eds {
namespace {

std::string_view end_of(LineEnd line_end) {
    constexpr std::string_view texts[] = {"", "\n", "\r\n", "\r"};
    return texts[static_cast<std::size_t>(line_end)];
}

// The text again, from nothing but the lines and their parts.
std::string put_together(const Document& document) {
    std::string text = document.has_byte_order_mark() ? "\xEF\xBB\xBF" : "";
    for (const Line& line : document.lines()) {
        EXPECT_EQ(line.begin, text.size());
        text += document.view({0, line.begin, line.end});
        text += end_of(line.line_end);
    }
    return text;
}

// Every span lies in its line, stands where its range says, and is what stands there.
void expect_spans_to_hold(const Document& document) {
    const auto expect_part = [&](const Span& span, std::uint32_t line, std::string_view part) {
        const Line& of = document.lines()[line];
        ASSERT_EQ(span.line, line);
        ASSERT_LE(of.begin, span.begin);
        ASSERT_LE(span.begin, span.end);
        ASSERT_LE(span.end, of.end);
        ASSERT_EQ(document.view(span), part);
        const diagnostic::Range range = document.range(span);
        ASSERT_EQ(range.start.line, line + 1);
        ASSERT_EQ(of.begin + range.start.column - 1, span.begin);
        ASSERT_EQ(range.end.column - range.start.column, part.size());
    };
    const auto number_of_lines = static_cast<std::uint32_t>(document.lines().size());
    for (std::uint32_t line = 0; line < number_of_lines; ++line) {
        const Line& of = document.lines()[line];
        const std::string_view whole = document.view(document.line_span(line));
        ASSERT_EQ(whole.find_first_of("\r\n"), std::string_view::npos);
        if (of.kind == LineKind::entry) {
            ASSERT_EQ(document.text()[of.mark], '=');
            expect_part(document.key_span(line), line, document.key(line));
            expect_part(document.value_span(line), line, document.value(line));
            ASSERT_EQ(document.key(line).find('='), std::string_view::npos);
        }
    }
    std::uint32_t next = document.preamble_end();
    for (const Section& section : document.sections()) {
        ASSERT_EQ(section.header, next);
        ASSERT_EQ(document.lines()[section.header].kind, LineKind::section);
        expect_part(document.name_span(section), section.header, document.name(section));
        next = section.end;
    }
    ASSERT_EQ(next, number_of_lines);
}

void expect_lossless(const std::string& text) {
    const Document document(text);
    ASSERT_EQ(document.text(), text);
    ASSERT_EQ(put_together(document), text);
    expect_spans_to_hold(document);
}

std::vector<LineKind> kinds_of(const Document& document) {
    std::vector<LineKind> kinds;
    for (const Line& line : document.lines()) {
        kinds.push_back(line.kind);
    }
    return kinds;
}

}  // namespace

TEST(EdsDocument, knows_sections_entries_comments_and_the_rest) {
    const Document document(
        "; first\n\n[FileInfo]\nFileName=a.eds\n# two\nEmpty=\nno entry\n [ 1000 ] ; trailing\n\t;x=1");
    using enum LineKind;
    EXPECT_EQ(kinds_of(document),
              (std::vector{comment, blank, section, entry, comment, entry, other, section, comment}));
    ASSERT_EQ(document.sections().size(), 2U);
    EXPECT_EQ(document.preamble_end(), 2U);
    EXPECT_EQ(document.name(document.sections()[0]), "FileInfo");
    EXPECT_EQ(document.name(document.sections()[1]), "1000");
    EXPECT_EQ(document.value("FileInfo", "FileName"), "a.eds");
    EXPECT_EQ(document.value("FileInfo", "Empty"), "");
}

TEST(EdsDocument, trims_blanks_and_keeps_their_place) {
    const Document document("[a]\n  Key \t=  some = value \t\n");
    EXPECT_EQ(document.key(1), "Key");
    EXPECT_EQ(document.value(1), "some = value");
    EXPECT_EQ(document.range(document.key_span(1)), (diagnostic::Range{{2, 3}, {2, 6}}));
    EXPECT_EQ(document.range(document.value_span(1)), (diagnostic::Range{{2, 11}, {2, 23}}));
    EXPECT_EQ(document.value_span(1).begin, 14U);
}

TEST(EdsDocument, ends_lines_at_every_kind_of_line_end) {
    const Document document("a=1\r\nb=2\nc=3\rd=4\r\r\ne=5");
    using enum LineEnd;
    std::vector<LineEnd> ends;
    for (const Line& line : document.lines()) {
        ends.push_back(line.line_end);
    }
    EXPECT_EQ(ends, (std::vector{crlf, lf, cr, cr, crlf, none}));
    EXPECT_EQ(document.value(0), "1");
    EXPECT_EQ(document.value(5), "5");
}

TEST(EdsDocument, leaves_a_byte_order_mark_out_of_names_and_columns) {
    const Document document("\xEF\xBB\xBF[FileInfo]\n");
    EXPECT_TRUE(document.has_byte_order_mark());
    ASSERT_NE(document.find("FileInfo"), nullptr);
    EXPECT_EQ(document.range(document.name_span(*document.find("FileInfo"))),
              (diagnostic::Range{{1, 2}, {1, 10}}));
    EXPECT_FALSE(Document("[FileInfo]").has_byte_order_mark());
}

TEST(EdsDocument, finds_sections_and_keys_whatever_their_case_and_the_first_of_them) {
    const Document document(
        "[DeviceInfo]\n;VendorName=nobody\nVendorName=first\nVENDORNAME=2nd\n"
        "[deviceinfo]\nVendorName=third\n");
    EXPECT_EQ(document.value("DEVICEINFO", "vendorname"), "first");
    EXPECT_EQ(document.value("DeviceInfo", "VendorNam"), std::nullopt);
    EXPECT_EQ(document.value("DeviceInfo", "VendorName2"), std::nullopt);
    EXPECT_EQ(document.find("Device"), nullptr);
    EXPECT_EQ(document.find("DeviceInfo"), &document.sections()[0]);
    EXPECT_TRUE(document.same_name(0, 1));
}

TEST(EdsDocument, lists_equal_names_one_after_the_other_in_file_order) {
    const Document document("[b]\n[a]\n[B]\n[c]\n[b]\n");
    const auto order = document.sections_by_name();
    const auto first = std::find(order.begin(), order.end(), 0U);
    ASSERT_LE(order.end() - first, 5);
    ASSERT_GE(order.end() - first, 3);
    EXPECT_EQ(first[1], 2U);
    EXPECT_EQ(first[2], 4U);
}

TEST(EdsDocument, takes_a_header_without_a_bracket_to_the_end_of_its_line) {
    const Document document("[1000 \nDataType=7\n");
    EXPECT_EQ(document.name(document.sections()[0]), "1000");
    EXPECT_EQ(document.lines()[0].mark, document.lines()[0].end);
    EXPECT_EQ(document.value("1000", "DataType"), "7");
}

TEST(EdsDocument, loses_nothing_of_odd_texts) {
    using namespace std::string_literals;
    for (const std::string& text : {""s,
                                    "\n"s,
                                    "\r"s,
                                    "\r\n"s,
                                    "\n\r"s,
                                    "="s,
                                    "["s,
                                    "]"s,
                                    "[]"s,
                                    "[]\n="s,
                                    ";"s,
                                    "\xEF\xBB\xBF"s,
                                    "\xEF\xBB"s,
                                    "\0\0\0"s,
                                    "[a\0b]\nk\0=v\0\n"s,
                                    "\xFF\xFE[\0a\0]\0"s,
                                    " \t \n\t"s,
                                    "=\n==\n=x=\n"s,
                                    "[a]\r\r\n[b]\n\n\r[c]"s,
                                    "\x1A"s}) {
        expect_lossless(text);
    }
}

TEST(EdsDocument, loses_nothing_of_the_printed_eds) {
    const std::string text = test::read_text(CGW_TEST_DATA "/eds/printed.eds");
    ASSERT_GT(text.size(), 10000U);
    expect_lossless(text);
}

TEST(EdsDocument, loses_nothing_of_what_cgw_writes) {
    std::size_t files = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(CGW_TEST_DATA "/golden")) {
        if (file.path().extension() == ".eds" || file.path().extension() == ".dcf") {
            ++files;
            expect_lossless(test::read_text(file.path()));
        }
    }
    EXPECT_GE(files, 3U);
}

TEST(EdsDocument, loses_nothing_of_random_and_mutated_texts) {
    const std::string printed = test::read_text(CGW_TEST_DATA "/eds/printed.eds");
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        test::RandomText random(seed);
        expect_lossless(seed % 4 == 0 ? random.mutated(printed) : random.text());
        if (HasFatalFailure()) {
            FAIL() << "seed " << seed;
        }
    }
}

TEST(EdsDocument, carries_a_million_sections_and_a_line_as_long_as_the_file) {
    std::string sections;
    for (int i = 0; i < 1000000; ++i) {
        sections += "[x]\n";
    }
    const Document many(std::move(sections));
    EXPECT_EQ(many.sections().size(), 1000000U);
    EXPECT_EQ(many.find("X"), &many.sections()[0]);
    const Document long_line("[a]\nk=" + std::string(4U * 1024U * 1024U, 'x'));
    EXPECT_EQ(long_line.value("a", "k")->size(), 4U * 1024U * 1024U);
    const Document returns(std::string(1000000, '\r'));
    EXPECT_EQ(returns.lines().size(), 1000000U);
}

}  // namespace cgw::eds
