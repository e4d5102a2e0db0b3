// docs/image-format.md and schemas/config-image.ksy are those that the table of fields gives.
#include "inspect/page.hpp"

#include <gtest/gtest.h>

#include "inspect/fields.hpp"
#include "inspect/kaitai.hpp"
#include "support/golden.hpp"

namespace cgw::inspect {
namespace {

const std::string page_path = "../../docs/image-format.md";

std::string page() {
    return test::read_text(std::filesystem::path(CGW_TEST_DATA) / page_path);
}

TEST(ImagePage, has_the_tables_of_the_fields) {
    test::expect_golden(page_path, with_tables(page()));
}

TEST(KaitaiSpecification, is_the_one_in_schemas) {
    test::expect_golden("../../schemas/config-image.ksy", kaitai_specification());
}

TEST(ImagePage, has_a_heading_for_every_record) {
    const std::string text = page();
    for (const Record& record : all_records()) {
        if (!record.fields.empty()) {
            EXPECT_NE(text.find("\n### `" + std::string(record.name) + "`"), std::string::npos)
                << record.name;
        }
    }
    EXPECT_NE(text.find("\n## Sections\n"), std::string::npos);
}

TEST(ImagePage, keeps_what_stands_around_the_tables) {
    EXPECT_EQ(with_tables("text\n\n| a | table | of another kind |\n|---|---|---|\n\n## Other\n| x |\n"),
              "text\n\n| a | table | of another kind |\n|---|---|---|\n\n## Other\n| x |\n");
    const std::string made = with_tables("### `identity`: stale\n\n| old |\n| old |\n\nafter\n| kept |\n");
    EXPECT_TRUE(made.starts_with("### `identity`: stale\n\n| Offset | Field | Type | Meaning |\n")) << made;
    EXPECT_TRUE(made.ends_with("\n\nafter\n| kept |\n")) << made;
}

}  // namespace
}  // namespace cgw::inspect
