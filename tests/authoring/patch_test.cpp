#include "authoring/patch.hpp"

#include <gtest/gtest.h>

namespace cgw::authoring {
namespace {

Edit edit(std::uint32_t line, std::uint32_t begin, std::uint32_t end, const std::string& text) {
    return {{{line, begin}, {line, end}}, text};
}

}  // namespace

TEST(Patch, changes_values_and_nothing_else) {
    const std::string text = "a = [1, 22, 3]  # b\r\nc = 4";
    EXPECT_EQ(edited(text, {edit(1, 6, 7, "100"), edit(1, 9, 11, "5"), edit(2, 5, 6, "0x4")}),
              "a = [100, 5, 3]  # b\r\nc = 0x4");
    EXPECT_EQ(edited(text, {}), text);
    EXPECT_EQ(edited(text, {edit(3, 1, 2, "x"), edit(2, 5, 9, "x"), edit(0, 0, 0, "x")}), text);
}

TEST(Patch, is_a_unified_diff_with_three_lines_around) {
    std::string text;
    for (int i = 1; i <= 20; ++i) {
        text += std::to_string(i) + "\n";
    }
    EXPECT_EQ(unified_diff("f", text, {edit(5, 1, 2, "five"), edit(20, 1, 3, "twenty")}),
              "--- f\n+++ f\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n"
              "@@ -17,4 +17,4 @@\n 17\n 18\n 19\n-20\n+twenty\n");
    EXPECT_EQ(unified_diff("f", text, {}), "");
    EXPECT_EQ(unified_diff("f", text, {edit(5, 1, 2, "5")}), "");
}

TEST(Patch, tells_a_last_line_without_its_end) {
    EXPECT_EQ(unified_diff("a b", "x = 1", {edit(1, 5, 6, "2")}),
              "--- a b\t\n+++ a b\t\n@@ -1,1 +1,1 @@\n-x = 1\n\\ No newline at end of file\n+x = 2\n"
              "\\ No newline at end of file\n");
}

}  // namespace cgw::authoring
