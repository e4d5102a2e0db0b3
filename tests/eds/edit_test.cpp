// Edits: what they change, and that every other byte stays.
#include "eds/edit.hpp"

#include <gtest/gtest.h>

#include "eds/random_text.hpp"

namespace cgw::eds {

TEST(EdsEdits, without_a_change_give_the_text_back) {
    const Document document("[a]\r\nk = v\nx");
    EXPECT_TRUE(Edits(document).empty());
    EXPECT_EQ(Edits(document).apply(), document.text());
}

TEST(EdsEdits, replace_a_value_a_key_and_a_name_where_they_stand) {
    const Document document("; c\r\n[ a ]\r\n k =  v  \nother=1");
    Edits edits(document);
    edits.replace(document.value_span(2), "new");
    edits.replace(document.key_span(3), "Other");
    edits.replace(document.name_span(document.sections()[0]), "b");
    EXPECT_EQ(edits.apply(), "; c\r\n[ b ]\r\n k =  new  \nOther=1");
}

TEST(EdsEdits, give_an_empty_value_its_first_text) {
    const Document document("[a]\nk=\n");
    Edits edits(document);
    edits.replace(document.value_span(1), "1");
    EXPECT_EQ(edits.apply(), "[a]\nk=1\n");
}

TEST(EdsEdits, remove_a_line_with_its_line_end) {
    const Document document("a=1\r\nb=2\rc=3\nd=4");
    Edits edits(document);
    edits.remove(1);
    edits.remove(3);
    EXPECT_EQ(edits.apply(), "a=1\r\nc=3\n");
}

TEST(EdsEdits, insert_lines_with_the_line_end_of_the_line_before) {
    const Document document("a=1\r\nb=2\n");
    Edits edits(document);
    edits.insert_after(0, "x=1");
    edits.insert_after(0, "y=2");
    edits.insert_after(1, "z=3");
    EXPECT_EQ(edits.apply(), "a=1\r\nx=1\r\ny=2\r\nb=2\nz=3\n");
}

TEST(EdsEdits, insert_behind_a_last_line_that_is_not_ended) {
    const Document document("a=1\r\nb=2");
    Edits edits(document);
    edits.insert_after(1, "c=3");
    EXPECT_EQ(edits.apply(), "a=1\r\nb=2\r\nc=3");
    const Document one_line("a=1");
    Edits behind(one_line);
    behind.insert_after(0, "b=2");
    EXPECT_EQ(behind.apply(), "a=1\nb=2");
}

TEST(EdsEdits, change_no_line_but_their_own) {
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        test::RandomText random(seed);
        const Document before(random.text());
        std::vector<std::uint32_t> entries;
        for (std::uint32_t line = 0; line < before.lines().size(); ++line) {
            if (before.lines()[line].kind == LineKind::entry) {
                entries.push_back(line);
            }
        }
        if (entries.empty()) {
            continue;
        }
        const std::uint32_t changed = entries[random.below(static_cast<std::uint32_t>(entries.size()))];
        Edits edits(before);
        edits.replace(before.value_span(changed), "changed");
        const Document after(edits.apply());
        ASSERT_EQ(after.lines().size(), before.lines().size()) << "seed " << seed;
        for (std::uint32_t line = 0; line < before.lines().size(); ++line) {
            ASSERT_EQ(after.lines()[line].line_end, before.lines()[line].line_end) << "seed " << seed;
            if (line != changed) {
                ASSERT_EQ(after.view(after.line_span(line)), before.view(before.line_span(line)));
            }
        }
        ASSERT_EQ(after.value(changed), "changed");
        ASSERT_EQ(after.key(changed), before.key(changed));
    }
}

}  // namespace cgw::eds
