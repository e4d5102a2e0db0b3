#include "diagnostic/rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>

#include "support/golden.hpp"

using cgw::diagnostic::all_rules;
using cgw::diagnostic::Level;
using cgw::diagnostic::Rule;

TEST(Rules, have_unique_codes_and_names_in_ascending_order) {
    std::set<std::string_view> names;
    std::string_view previous;
    for (const Rule* rule : all_rules()) {
        EXPECT_LT(previous, rule->code);
        previous = rule->code;
        EXPECT_TRUE(names.insert(rule->name).second) << rule->name;
    }
    EXPECT_GE(names.size(), 60U);
}

TEST(Rules, are_written_in_one_style) {
    const std::regex code("E(0[0-9]|1[0-2])[0-9]{2}");
    const std::regex name("[a-z0-9]+(-[a-z0-9]+)+");
    for (const Rule* rule : all_rules()) {
        EXPECT_TRUE(std::regex_match(std::string(rule->code), code)) << rule->code;
        EXPECT_TRUE(std::regex_match(std::string(rule->name), name)) << rule->name;
        const Level level = rule->code < "E0300"   ? Level::error
                            : rule->code < "E0400" ? Level::warning
                                                   : Level::note;
        const bool is_of_one_level = rule->code < "E0500";
        EXPECT_TRUE(rule->level == level || !is_of_one_level) << rule->code;
        ASSERT_FALSE(rule->summary.empty()) << rule->code;
        EXPECT_NE(rule->summary.back(), '.') << rule->code;
        ASSERT_FALSE(rule->why.empty()) << rule->code;
        EXPECT_EQ(rule->why.back(), '.') << rule->code;
        EXPECT_LE(std::count(rule->why.begin(), rule->why.end(), '.'), 4) << rule->code;
    }
}

TEST(Rules, of_every_header_are_in_the_table) {
    const std::regex name("\n    RULE\\([a-z0-9_]+\\)");
    std::ptrdiff_t names = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CGW_SAMPLES "/../lib/diagnostic/rules")) {
        if (entry.path().extension() == ".hpp") {
            const std::string header = cgw::test::read_text(entry.path());
            names += std::distance(std::sregex_iterator(header.begin(), header.end(), name),
                                   std::sregex_iterator());
        }
    }
    EXPECT_EQ(static_cast<std::size_t>(names), all_rules().size());
}

TEST(Rules, about_the_plant_cite_the_manual_or_a_ruling) {
    for (const Rule* rule : all_rules()) {
        if (rule->code >= "E0200" && rule->code < "E0600") {  // E06 and E07 are not about plants
            EXPECT_NE(rule->reference.find_first_of("GD"), std::string_view::npos) << rule->code;
        }
    }
}
