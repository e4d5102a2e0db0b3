// Slips in the files of descriptions stop the build with a finding.
#include "catalogue/description_reader.hpp"

#include <gtest/gtest.h>

#include <string>

#include "catalogue/findings_text.hpp"

namespace {

using cgw::catalogue::Descriptions;

const std::string error_cells =
    "devices = [\"gateway\"]\ncause = [\"a\"]\nresponse = [\"b\"]\naction = [\"c\"]\nclears = \"d\"\n"
    "section = \"GWM 9\"\n";

std::string errors(const std::string& text) {
    Descriptions descriptions;
    cgw::diagnostic::Findings findings;
    const bool good = descriptions.read_errors(text, "errors.toml", findings);
    EXPECT_EQ(good, findings.all().empty());
    return cgw::test::findings_text(findings);
}

std::string objects(const std::string& text) {
    Descriptions descriptions;
    cgw::diagnostic::Findings findings;
    const bool good = descriptions.read_objects(text, "objects.toml", findings);
    EXPECT_EQ(good, findings.all().empty());
    return cgw::test::findings_text(findings);
}

std::string error(const std::string& cells) {
    return errors("program = \"application\"\n[[error]]\n" + cells);
}

TEST(DescriptionReader, takes_a_whole_error) {
    EXPECT_EQ(error("number = 3070\n" + error_cells), "");
    EXPECT_EQ(error("key = \"some-error\"\n" + error_cells), "");
}

TEST(DescriptionReader, an_error_has_a_number_or_a_key) {
    EXPECT_NE(error(error_cells).find("`number` or a `key`"), std::string::npos);
}

TEST(DescriptionReader, an_error_says_everything) {
    EXPECT_NE(error("number = 3070\ndevices = [\"gateway\"]\n").find("`cause` is missing"),
              std::string::npos);
    EXPECT_NE(error("number = 3070\ndevices = [\"gateway\"]\n").find("`clears` is missing"),
              std::string::npos);
    EXPECT_NE(error("number = 3070\ndevices = [\"toaster\"]\n").find("`devices` are"), std::string::npos);
}

TEST(DescriptionReader, names_what_it_does_not_know) {
    EXPECT_NE(error("number = 3070\ncauses = []\n" + error_cells).find("unknown key `causes`"),
              std::string::npos);
    EXPECT_NE(errors("program = \"boot\"\n[[error]]\nnumber = 1\n" + error_cells).find("`program` is"),
              std::string::npos);
    EXPECT_NE(errors("program = \"application\"\n").find("`[[error]]` is missing"), std::string::npos);
    EXPECT_NE(errors("program = \n"), "");
}

TEST(DescriptionReader, numbers_are_numbers) {
    EXPECT_NE(error("number = \"3070\"\n" + error_cells).find("`number` is an integer"), std::string::npos);
    EXPECT_NE(error("number = 3070\nwith = [70000]\n" + error_cells).find("no number of 16 bits"),
              std::string::npos);
    EXPECT_NE(error("number = 3070\nwith = [-1]\n" + error_cells).find("no number of 16 bits"),
              std::string::npos);
}

TEST(DescriptionReader, an_object_has_index_text_and_section) {
    EXPECT_EQ(objects("[[object]]\nindex = 0x2005\ntext = \"a\"\nsection = \"GWM 5\"\n"), "");
    EXPECT_NE(objects("[[object]]\ntext = \"a\"\nsection = \"GWM 5\"\n").find("`index` is missing"),
              std::string::npos);
    EXPECT_NE(objects("[[object]]\nindex = 0x2005\nsection = \"GWM 5\"\n").find("`text` is missing"),
              std::string::npos);
    EXPECT_NE(
        objects("[[object]]\nindex = 0x2005\ntext = \"\"\nsection = \"GWM 5\"\n").find("`text` is empty"),
        std::string::npos);
    EXPECT_NE(objects("[[objects]]\nindex = 1\n").find("unknown key `objects`"), std::string::npos);
    EXPECT_NE(objects("x = "), "");
}

TEST(DescriptionReader, several_objects_of_one_table_count_along) {
    Descriptions descriptions;
    cgw::diagnostic::Findings findings;
    ASSERT_TRUE(
        descriptions.read_objects("[[object]]\nindex = 0x1804\nlast_index = 0x1805\nsub = 1\n"
                                  "text = \"COB-ID of TPDO{5}\"\nsource = \"{16404} {180Fh}\"\n"
                                  "section = \"GWM 7\"\n",
                                  "objects.toml", findings));
    const auto rows = descriptions.objects();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1].index, 0x1805);
    EXPECT_FALSE(rows[1].whole);
    EXPECT_EQ(rows[1].text, "COB-ID of TPDO6");
    EXPECT_EQ(rows[1].source, "16405 1810h");
}

}  // namespace
