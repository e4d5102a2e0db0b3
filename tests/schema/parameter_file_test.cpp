// The text of the schema. What it accepts and refuses is judged in tests/judges/editor.
#include "schema/parameter_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>

#include "catalogue/catalogue.hpp"
#include "catalogue/cells.hpp"
#include "schema/declaration.hpp"
#include "schema/spelling.hpp"
#include "support/golden.hpp"

namespace cgw {
namespace {

using parameter::Catalogue;
using parameter::Device;
using parameter::Row;

const Catalogue& shipped() {
    static const Catalogue catalogue(catalogue::shipped_rows());
    return catalogue;
}

bool matches(const std::string& key, const Row& row) {
    return std::regex_search(key, std::regex(schema::spelling_pattern(row, shipped())));
}

const Row& row(Device device, std::uint16_t number) {
    return *shipped().find(device, number);
}

TEST(SchemaParameterFile, is_the_committed_one) {
    const std::filesystem::path committed =
        std::filesystem::path(CGW_SAMPLES).parent_path() / "schemas/parameter-file.schema.json";
    const std::string expected = test::read_text(committed);
    const std::string now = schema::parameter_file_schema(shipped());
    EXPECT_TRUE(expected == now) << test::first_difference(expected, now)
                                 << "\ncgw schema -o schemas/parameter-file.schema.json makes it again";
}

TEST(SchemaParameterFile, does_not_know_measurements_as_keys) {
    const std::string text = schema::parameter_file_schema(shipped());
    EXPECT_NE(text.find("\"governor16400\""), std::string::npos);
    EXPECT_EQ(text.find("\"governor2000\""), std::string::npos);
}

TEST(SchemaSpelling, names_a_row_as_the_catalogue_finds_it) {
    for (const Device device : {Device::governor, Device::gateway}) {
        for (const Row* one : shipped().rows(device)) {
            for (const std::string& key : schema::canonical_spellings(*one)) {
                if (std::isdigit(static_cast<unsigned char>(key.front())) == 0) {
                    EXPECT_EQ(shipped().find(device, key), one) << key;
                }
            }
        }
    }
}

TEST(SchemaSpelling, has_patterns_that_take_the_canonical_spellings) {
    for (const Row* one : shipped().rows(Device::gateway)) {  // all rows are judged in tests/judges/editor
        const std::regex pattern(schema::spelling_pattern(*one, shipped()));
        for (const std::string& key : schema::canonical_spellings(*one)) {
            EXPECT_TRUE(std::regex_search(key, pattern)) << key;
        }
    }
}

TEST(SchemaSpelling, takes_any_case_aliases_blanks_and_misprints) {
    const Row& identifier = row(Device::gateway, 16405);
    for (const char* key :
         {"16405", "canoptpdo5-16id(1)", "CANOPTPDO5-16ID  (1)", " 16405\tCanOpTPDO5-16ID (1) "}) {
        EXPECT_TRUE(matches(key, identifier)) << key;
    }
    EXPECT_TRUE(matches("CanOpTPDO5-16ID", row(Device::gateway, 16404)));
    EXPECT_TRUE(matches("hzmcansegmentorbaudrate", row(Device::gateway, 4416)));
    EXPECT_TRUE(matches("409", row(Device::governor, 416)));
    EXPECT_TRUE(matches("409 CanBaudrate", row(Device::governor, 416)));
    EXPECT_TRUE(matches("4901 ChanType_Setp1Ext", row(Device::governor, 4901)));
    EXPECT_TRUE(matches("812 what the governor calls it", row(Device::governor, 812)));
}

TEST(SchemaSpelling, refuses_what_means_another_parameter_or_none) {
    const Row& identifier = row(Device::gateway, 16405);
    for (const char* key : {"16404", "016405", "16405x", "CanOpTPDO5-16ID", "CanOpTPDO5-16ID(11)",
                            "16404 CanOpTPDO5-16ID(1)"}) {
        EXPECT_FALSE(matches(key, identifier)) << key;
    }
    EXPECT_FALSE(matches("4901", row(Device::governor, 4900)));
    EXPECT_FALSE(matches("8120", row(Device::governor, 812)));
}

TEST(SchemaDeclaration, has_every_cell_that_a_declaration_may_have) {
    std::vector<std::string_view> described;
    for (const schema::DeclarationCell& cell : schema::declaration_cells()) {
        described.push_back(cell.name);
    }
    std::vector<std::string_view> read;
    for (const catalogue::Cell& cell : catalogue::all_cells()) {
        if (cell.in_declaration) {
            read.push_back(cell.name);
        }
    }
    std::sort(described.begin(), described.end());
    std::sort(read.begin(), read.end());
    EXPECT_EQ(described, read);
}

}  // namespace
}  // namespace cgw
