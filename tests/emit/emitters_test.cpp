#include <gtest/gtest.h>

#include <fmt/format.h>
#include <set>

#include "eds/writer.hpp"
#include "plant.hpp"
#include "support/golden.hpp"

namespace cgw::emit {

TEST(Emitters, are_found_by_name) {
    for (const std::string name :
         {"eds", "dcf", "xdd", "xdc", "concise-dcf", "dbc", "pdo-table", "entry-sheet", "report", "image",
          "image-source", "c-header", "structured-text", "stx", "python-canopen", "points"}) {
        ASSERT_NE(find_emitter(name), nullptr) << name;
        EXPECT_EQ(find_emitter(name)->name, name);
    }
    EXPECT_EQ(find_emitter("dbx"), nullptr);
    EXPECT_EQ(find_emitter(""), nullptr);
    EXPECT_EQ(all_emitters().size(), 16U);
}

TEST(Emitters, have_a_summary_a_function_and_a_first_format) {
    for (const Emitter& emitter : all_emitters()) {
        EXPECT_FALSE(emitter.summary.empty());
        EXPECT_NE(emitter.emit, nullptr);
        EXPECT_FALSE(emitter.formats.empty());
    }
}

TEST(Emitters, name_the_files_that_build_writes) {
    std::set<std::string> names;
    for (const Emitter& emitter : all_emitters()) {
        for (const Format& format : emitter.formats) {
            if (const std::string name = file_name(format, {}); !name.empty()) {
                EXPECT_TRUE(names.insert(name).second) << name;
            }
        }
    }
    EXPECT_EQ(names,
              (std::set<std::string>{"CANopenGateway.eds", "CANopenGateway.dcf", "CANopenGateway.dbc",
                                     "CANopenGateway.xdd", "CANopenGateway.xdc", "pdo-table.md",
                                     "pdo-table.csv", "pdo-table.json", "entry-sheet.md", "entry-sheet.csv",
                                     "entry-sheet.html", "report.html", "report.md", "gateway-config.bin"}));
}

TEST(Emitters, are_documented_with_the_files_they_write) {
    for (const std::string page : {"artefacts.md", "command-line.md"}) {
        const std::string text = test::read_text(CGW_TEST_DATA "/../../docs/" + page);
        for (const Emitter& emitter : all_emitters()) {
            EXPECT_NE(text.find(fmt::format("| `{}` |", emitter.name)), std::string::npos)
                << page << ": " << emitter.name;
            const std::string name = file_name(emitter.formats.front(), {});
            EXPECT_NE(text.find(name), std::string::npos) << page << ": " << name;
        }
    }
}

TEST(EmitterFormats, begin_with_the_default) {
    const Emitter& table = *find_emitter("pdo-table");
    EXPECT_EQ(find_format(table, "")->name, "text");
    EXPECT_EQ(find_format(table, "csv")->file_name, "pdo-table.csv");
    EXPECT_EQ(find_format(table, "xlsx"), nullptr);
}

TEST(EmitEds, writes_the_plants_dictionary) {
    const test::SamplePlant plant(test::manual_configuration());
    EXPECT_EQ(plant.emit("eds", ""), eds::write(plant.dictionary));
    EXPECT_NE(
        plant.emit("eds", "").find("Description=Genset 2, starboard, configuration 0123456789abcdef\r\n"),
        std::string::npos);
}

TEST(EmitPdoTable, takes_an_unnamed_format_for_text) {
    const test::SamplePlant plant(test::manual_configuration());
    EXPECT_EQ(plant.emit("pdo-table", ""), plant.emit("pdo-table", "text"));
    EXPECT_NE(plant.emit("pdo-table", "csv"), plant.emit("pdo-table", "text"));
}

}  // namespace cgw::emit
