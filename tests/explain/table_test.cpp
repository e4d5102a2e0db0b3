// One table, four formats.
#include "explain/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/utf8.hpp"
#include "explain/text.hpp"

namespace {

using cgw::explain::Column;
using cgw::explain::find_table_format;
using cgw::explain::Table;
using cgw::explain::TableFormat;

std::string render(const Table& table, std::string_view format) {
    const TableFormat* found = find_table_format(format);
    EXPECT_NE(found, nullptr) << format;
    return found != nullptr ? found->render(table) : "";
}

Table fruit() {
    Table table{"fruit", false, {}, {}};
    table.columns = {{"number", "number", cgw::explain::everywhere, true},
                     {"name", "name"},
                     {"grams", "", cgw::explain::in_data, true},
                     {"text", "meaning"}};
    table.rows = {{"1", "apple", "180.5", "red, \"round\""}, {"12", "pear|tree", "", "green *and* long"}};
    return table;
}

TEST(ExplainTable, a_terminal_gets_aligned_columns) {
    EXPECT_EQ(render(fruit(), "table"),
              "number  name       meaning\n"
              "1       apple      red, \"round\"\n"
              "12      pear|tree  green *and* long\n");
}

TEST(ExplainTable, the_last_column_wraps_at_80) {
    Table table = fruit();
    table.rows[0][3] = std::string(20, 'a') + " " + std::string(30, 'b') + " " + std::string(20, 'c');
    EXPECT_EQ(render(table, "table"), "number  name       meaning\n1       apple      " +
                                          std::string(20, 'a') + " " + std::string(30, 'b') + "\n" +
                                          std::string(19, ' ') + std::string(20, 'c') +
                                          "\n12      pear|tree  green *and* long\n");
}

TEST(ExplainTable, the_last_column_moves_below_when_the_others_leave_no_room) {
    Table table = fruit();
    table.rows[1][1] = std::string(50, 'x');
    table.rows[0][3] = std::string(40, 'y') + " end";
    const std::string text = render(table, "table");
    EXPECT_NE(text.find("1       apple\n    yyyy"), std::string::npos) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(cgw::base::width_of(line), 80U) << line;
        EXPECT_FALSE(line.ends_with(' ')) << line;
    }
}

TEST(ExplainTable, a_column_that_is_empty_throughout_is_left_out_on_a_terminal) {
    Table table = fruit();
    table.rows[0][1] = table.rows[1][1] = "";
    EXPECT_TRUE(render(table, "table").starts_with("number  meaning\n")) << render(table, "table");
}

TEST(ExplainTable, groups_have_headings) {
    Table table = fruit();
    table.columns.insert(table.columns.begin(), Column{"kind", "", cgw::explain::in_data});
    table.rows[0].insert(table.rows[0].begin(), "stone");
    table.rows[1].insert(table.rows[1].begin(), "seed");
    table.grouped = true;
    EXPECT_EQ(render(table, "table"),
              "stone\n\nnumber  name   meaning\n1       apple  red, \"round\"\n"
              "\nseed\n\nnumber  name       meaning\n12      pear|tree  green *and* long\n");
    EXPECT_NE(render(table, "md").find("\n\n## seed\n\n| number |"), std::string::npos);
    EXPECT_TRUE(render(table, "csv").starts_with("kind,number,name"));
}

TEST(ExplainTable, markdown_cells_are_literal) {
    EXPECT_EQ(render(fruit(), "md"),
              "| number | name | meaning |\n| --- | --- | --- |\n| 1 | apple | red, \"round\" |\n"
              "| 12 | pear\\|tree | green \\*and\\* long |\n");
}

TEST(ExplainTable, csv_is_quoted_where_needed_and_ends_lines_with_crlf) {  // RFC 4180
    EXPECT_EQ(render(fruit(), "csv"),
              "number,name,grams,text\r\n1,apple,180.5,\"red, \"\"round\"\"\"\r\n"
              "12,pear|tree,,green *and* long\r\n");
}

TEST(ExplainTable, json_has_numbers_null_and_a_format_version) {
    EXPECT_EQ(render(fruit(), "json"),
              "{\"format_version\":1,\"fruit\":[{\"number\":1,\"name\":\"apple\",\"grams\":180.5,"
              "\"text\":\"red, \\\"round\\\"\"},{\"number\":12,\"name\":\"pear|tree\",\"grams\":null,"
              "\"text\":\"green *and* long\"}]}\n");
}

TEST(ExplainTable, formats_are_found_by_name) {
    EXPECT_EQ(cgw::explain::table_formats().front().name, "table");
    EXPECT_TRUE(find_table_format("md")->for_people);
    EXPECT_FALSE(find_table_format("csv")->for_people);
    EXPECT_EQ(find_table_format("xml"), nullptr);
}

}  // namespace
