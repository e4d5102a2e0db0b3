#include "page/page.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cgw::page {
namespace {

Page page_of(Block block) {
    return {"Plant", {}, {std::move(block)}};
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

const std::string hostile = "</td><script>alert(\"1\")</script> & | `x` *y*\n# z \x1b[31m";

}  // namespace

TEST(Html, is_one_page_without_anything_from_elsewhere) {
    const std::string html = render_html(page_of(Paragraph{"Hello."}));
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    EXPECT_TRUE(html.ends_with("</html>\n"));
    EXPECT_TRUE(has(html, "<h1>Plant</h1>"));
    EXPECT_TRUE(has(html, "<p>Hello.</p>"));
    for (const std::string_view foreign :
         {"<script", "http:", "https:", "url(", "@import", "<link", "<img"}) {
        EXPECT_FALSE(has(html, foreign)) << foreign;
    }
}

TEST(Html, lists_its_sections_behind_what_comes_first) {
    Page page{"Plant",
              {"node 1"},
              {Verdict{Tone::good, "it works", {"no errors"}}, Heading{2, "Buses"}, Heading{3, "CAN1"},
               Heading{2, "PDOs"}}};
    const std::string html = render_html(page);
    const std::size_t verdict = html.find("<strong>OK: it works</strong>");
    const std::size_t contents = html.find("<li><a href=\"#s2\">PDOs</a></li>");
    ASSERT_NE(verdict, std::string::npos);
    ASSERT_NE(contents, std::string::npos);
    EXPECT_LT(verdict, contents);
    EXPECT_LT(contents, html.find("<h2 id=\"s1\">Buses</h2>"));
    EXPECT_TRUE(has(html, "<h3>CAN1</h3>"));
    EXPECT_FALSE(has(html, "#s3"));
    EXPECT_TRUE(has(html, "<p class=\"subtitle\">node 1</p>"));
}

TEST(Html, heads_rows_and_columns_and_draws_bars) {
    const std::string html = render_html(page_of(Table{
        "Loads", {{"Message"}, {"Load", true}}, {{"TPDO1", {"4 %", Tone::bad, Bar{0.04, "4 % of it"}}}}}));
    EXPECT_TRUE(has(html, "<caption>Loads</caption>"));
    EXPECT_TRUE(has(html, "<th scope=\"col\" class=\"number\">Load</th>"));
    EXPECT_TRUE(has(html, "<th scope=\"row\">TPDO1</th>"));
    EXPECT_TRUE(has(html, "<span class=\"bad\">4 %</span>"));
    EXPECT_TRUE(has(html, "aria-label=\"4 % of it\""));
    EXPECT_TRUE(has(html, "width=\"4.0\""));
}

TEST(Html, bars_end_at_their_limit) {
    for (const double share :
         {1.5, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const std::string html =
            render_html(page_of(Table{"T", {{"x"}}, {{{"a", Tone::bad, Bar{share, "m"}}}}}));
        EXPECT_TRUE(has(html, "class=\"bad\" x=\"0\" y=\"0\" width=\"100.0\"")) << share;
    }
    const std::string html = render_html(page_of(Table{"T", {{"x"}}, {{{"a", Tone::bad, Bar{-1, "m"}}}}}));
    EXPECT_TRUE(has(html, "class=\"bad\" x=\"0\" y=\"0\" width=\"0.0\""));
}

TEST(Html, draws_frames_in_rows_of_four_bytes) {
    const std::string html = render_html(page_of(
        Frame{"The 6 bytes", 6, {{0, 16, "Speed"}, {16, 32, "a name that is far too long to stand in it"}}}));
    EXPECT_TRUE(has(html, "viewBox=\"0 0 481 132\""));
    EXPECT_TRUE(has(html, "aria-label=\"The 6 bytes\""));
    EXPECT_TRUE(has(html, ">byte 5</text>"));
    EXPECT_TRUE(has(html, ">Speed</text>"));
    EXPECT_TRUE(has(html, "\u2026</text>"));
    EXPECT_TRUE(has(html, "<title>a name that is far too long to stand in it</title>"));
}

TEST(Html, draws_what_is_in_use_of_a_range) {
    const std::string html =
        render_html(page_of(Strip{"Identifiers", 0, 2047, {{0, 0, "NMT"}, {2047, 2047, "last", Tone::bad}}}));
    EXPECT_TRUE(has(html, "<title>NMT</title><rect class=\"plain\" x=\"0.0\""));
    EXPECT_TRUE(has(html, "<title>last</title><rect class=\"bad\" x=\"957.0\" y=\"5\" width=\"3.0\""));
}

TEST(BothForms, are_safe_from_any_text) {
    Page page{hostile, {hostile}, {}};
    page.blocks = {Heading{2, hostile},
                   Paragraph{hostile, Tone::bad},
                   Verdict{Tone::warning, hostile, {hostile}},
                   Table{hostile, {{hostile}}, {{{hostile, Tone::good, Bar{0.5, hostile}}}}},
                   Items{true, {hostile}},
                   Frame{hostile, 8, {{0, 64, hostile}}},
                   Strip{hostile, 0, 10, {{1, 2, hostile}}}};
    const std::string html = render_html(page);
    EXPECT_FALSE(has(html, "<script"));
    EXPECT_FALSE(has(html, "\x1b"));
    const std::string markdown = render_markdown(page);
    EXPECT_EQ(markdown.find("<script"), markdown.find("\\<script") + 1);
    EXPECT_FALSE(has(markdown, "\x1b"));
    EXPECT_FALSE(has(markdown, "\n# z"));
    EXPECT_FALSE(has(markdown, " | `x`"));
}

TEST(Markdown, says_the_same) {
    Page page{"Plant", {"node 1"}, {}};
    page.blocks = {Verdict{Tone::warning, "look", {"why"}},
                   Heading{2, "Loads"},
                   Paragraph{"Text.", Tone::bad},
                   Table{"All", {{"Message"}, {"Load", true}}, {{"TPDO1", "4 %"}}},
                   Items{true, {"one", "two"}},
                   Frame{"drawn", 2, {{0, 16, "Speed"}}}};
    EXPECT_EQ(render_markdown(page),
              "# Plant\n\nnode 1\n\n**Warning:** look\n\n- why\n\n## Loads\n\n**Error:** Text.\n\nAll\n\n"
              "| Message | Load |\n|---|---:|\n| TPDO1 | 4 % |\n\n1. one\n2. two\n");
}

}  // namespace cgw::page
