#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "authoring/clone.hpp"
#include "compare/compare.hpp"
#include "config/numbers.hpp"
#include "diagnostic/rules/notes.hpp"
#include "driver/check_file.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"
#include "properties/random_plant.hpp"

namespace cgw::test {
namespace {

constexpr std::uint32_t plants = 60;
constexpr std::uint32_t orders = 2;

class RandomPlants : public testing::Test {
  protected:
    void SetUp() override {
        path_ =
            std::filesystem::temp_directory_path() / ("cgw-plant-" + std::to_string(::getpid()) + ".toml");
    }
    void TearDown() override { std::filesystem::remove(path_); }

    driver::CheckedFile check(const std::string& text) {
        std::ofstream(path_, std::ios::binary) << text;
        return driver::check_file(path_.string());
    }

  private:
    std::filesystem::path path_;
};

// Code and message of every finding that is not about spelling, without the places, sorted.
std::vector<std::string> findings(const driver::CheckedFile& file) {
    std::vector<std::string> all;
    for (const diagnostic::Diagnostic& finding : file.findings.all()) {
        if (finding.rule == &diagnostic::rules::manual_misprint) {
            continue;
        }
        all.push_back(std::string(finding.rule->code) + " " + finding.message + " | " + finding.help);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Every artefact in one string, but for those whose name begins with one of `without`; empty when the plant
// is not valid.
std::string artefacts(const driver::CheckedFile& file, std::initializer_list<std::string_view> without = {}) {
    std::string all;
    if (!file.valid()) {
        return all;
    }
    const auto plant = driver::Plant::make(file);
    for (const driver::Artefact& artefact : driver::build_artefacts(plant.value().view())) {
        if (std::any_of(without.begin(), without.end(),
                        [&](std::string_view name) { return artefact.file_name.starts_with(name); })) {
            continue;
        }
        all += artefact.file_name + ":";
        all.append(artefact.content.begin(), artefact.content.end());
    }
    return all;
}

TEST_F(RandomPlants, resolve_alike_every_time) {
    std::uint32_t valid = 0;
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        const RandomPlant plant(seed, seed % 3 != 0);
        const driver::CheckedFile once = check(plant.text());
        const driver::CheckedFile again = check(plant.text());
        valid += once.valid() ? 1U : 0U;
        ASSERT_EQ(findings(once), findings(again)) << "seed " << seed;
        ASSERT_EQ(artefacts(once), artefacts(again)) << "seed " << seed;
    }
    EXPECT_GT(valid, plants / 4) << "too few of the careful plants are valid to show anything";
    EXPECT_LT(valid, plants) << "none of the careless plants is wrong";
}

TEST_F(RandomPlants, do_not_depend_on_order_and_spelling) {
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        const RandomPlant plant(seed, seed % 3 != 0);
        const driver::CheckedFile sorted = check(plant.text());
        for (std::uint32_t order = 1; order <= orders; ++order) {
            const driver::CheckedFile shuffled = check(plant.text(order));
            ASSERT_EQ(findings(sorted), findings(shuffled)) << "seed " << seed << " order " << order;
            ASSERT_EQ(artefacts(sorted), artefacts(shuffled)) << "seed " << seed << " order " << order;
            ASSERT_EQ(sorted.not_verified, shuffled.not_verified) << "seed " << seed << " order " << order;
        }
    }
}

// A zero for every parameter of the device that the file does not set and that may be 0.
std::string zeros(const driver::CheckedFile& file, parameter::Device device,
                  const parameter::ParameterSet& set) {
    std::string lines;
    for (const parameter::Row* row : file.catalogue->rows(device)) {
        if (row->settable() && row->allows(0) && set.find(row->number) == nullptr) {
            lines += fmt::format("{} = 0\n", row->number);
        }
    }
    return lines;
}

std::string with_zeros(const driver::CheckedFile& file, std::string text) {
    for (const auto& [table, lines] :
         {std::pair("[governor.parameters]\n",
                    zeros(file, parameter::Device::governor, file.settings.governor)),
          std::pair("[gateway.parameters]\n",
                    zeros(file, parameter::Device::gateway, file.settings.gateway))}) {
        text.insert(text.find(table) + std::strlen(table), lines);
    }
    return text;
}

// D49: what is not set is 0, so the configuration id need not tell the two apart. The entry sheet does, also
// on the report: it lists what the file states.
TEST_F(RandomPlants, are_the_same_when_zeros_are_written_out) {
    constexpr std::uint32_t fewer = plants / 3;  // files of a thousand lines
    std::uint32_t valid = 0;
    for (std::uint32_t seed = 1; seed <= fewer; ++seed) {
        const RandomPlant plant(seed, true);
        const driver::CheckedFile file = check(plant.text());
        const driver::CheckedFile written_out = check(with_zeros(file, plant.text()));
        valid += written_out.valid() ? 1U : 0U;
        ASSERT_EQ(findings(file), findings(written_out)) << "seed " << seed;
        ASSERT_EQ(artefacts(file, {"entry-sheet", "report"}),
                  artefacts(written_out, {"entry-sheet", "report"}))
            << "seed " << seed;
    }
    EXPECT_GT(valid, fewer / 2);
}

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
    Lines lines(1);
    for (const char character : text) {
        if (character == '\n') {
            lines.emplace_back();
        } else {
            lines.back() += character;
        }
    }
    return lines;
}

// The lines, from 1, of the title, 427 and identifiers: what a copy may change.
std::set<std::size_t> lines_that_may_change(const driver::CheckedFile& file, const Lines& lines) {
    std::set<std::size_t> may;
    for (const auto& [number, assignment] : file.settings.gateway.all()) {
        if (number == config::gateway::node_id ||
            (number >= config::gateway::tpdo_identifier && number < config::gateway::tpdo_identifier + 12)) {
            may.insert(assignment.where.range.start.line);
        }
    }
    may.insert(static_cast<std::size_t>(std::find(lines.begin(), lines.end(), "title = \"random\"") -
                                        lines.begin()) +
               1);
    return may;
}

// A node id that the network leaves free.
std::uint8_t other_node(const driver::CheckedFile& file, Dice& dice) {
    for (;;) {
        const auto node = static_cast<std::uint8_t>(dice.between(1, 127));
        const auto& listed = file.settings.network_nodes;
        const bool is_listed = std::any_of(listed.begin(), listed.end(),
                                           [node](const auto& other) { return other.node_id == node; });
        if (node != file.configuration.node_id && node != file.configuration.partner_node_id && !is_listed) {
            return node;
        }
    }
}

std::string cloned(const driver::CheckedFile& file, const std::string& text,
                   const authoring::CloneRequest& request) {
    diagnostic::Findings findings;
    return authoring::clone_text(text, file.settings, file.configuration, request, findings).value_or("");
}

void expect_only_identifiers_differ(const driver::CheckedFile& a, const driver::CheckedFile& b, bool kept) {
    const compare::Comparison comparison = compare::compare({a.settings, a.configuration, *a.catalogue},
                                                            {b.settings, b.configuration, *b.catalogue});
    for (const compare::ParameterDifference& difference : comparison.parameters) {
        EXPECT_EQ(difference.row->device, parameter::Device::gateway);
        if (difference.row->number == config::gateway::node_id) {
            EXPECT_EQ(difference.b, b.configuration.node_id);
            continue;
        }
        EXPECT_FALSE(kept);
        EXPECT_GE(difference.row->number, config::gateway::tpdo_identifier);
        EXPECT_LT(difference.row->number, config::gateway::tpdo_identifier + 12);
        EXPECT_EQ(difference.b - difference.a, b.configuration.node_id - a.configuration.node_id);
    }
    EXPECT_EQ(comparison.parameters.size(), kept ? 1U : 13U);
    ASSERT_EQ(comparison.otherwise.size(), 1U);
    EXPECT_EQ(comparison.otherwise[0].kind, "title");
}

TEST_F(RandomPlants, keep_everything_but_the_identifiers_when_cloned) {
    std::uint32_t valid = 0;
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        SCOPED_TRACE(seed);
        const bool kept = seed % 3 == 0;
        const std::string text =
            RandomPlant(seed, true, kept ? Identifiers::free_pool : Identifiers::follow_node).text(seed);
        const driver::CheckedFile original = check(text);
        if (!original.valid()) {
            continue;
        }
        ++valid;
        Dice dice(seed);
        const std::string copy_text = cloned(original, text, {other_node(original, dice), "copy", kept});
        const driver::CheckedFile copy = check(copy_text);
        ASSERT_TRUE(copy.valid()) << copy_text;
        expect_only_identifiers_differ(original, copy, kept);
        const Lines before = lines_of(text);
        const Lines after = lines_of(copy_text);
        const std::set<std::size_t> may_change = lines_that_may_change(original, before);
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t line = 1; line <= before.size(); ++line) {
            EXPECT_TRUE(may_change.contains(line) || before[line - 1] == after[line - 1]) << line;
        }
        EXPECT_EQ(cloned(copy, copy_text, {original.configuration.node_id, "random", kept}), text);
    }
    EXPECT_GT(valid, plants / 4) << "too few plants are valid to show anything";
}

TEST_F(RandomPlants, are_refused_in_words_when_a_piece_is_missing) {
    for (std::uint32_t seed = 1; seed <= plants; ++seed) {
        const std::string text = RandomPlant(seed, seed % 2 == 0).text(seed);
        Dice dice(seed);
        const std::string cut = text.substr(0, dice.below(static_cast<std::uint32_t>(text.size())));
        const driver::CheckedFile file = check(cut);
        for (const diagnostic::Diagnostic& finding : file.findings.all()) {
            ASSERT_FALSE(finding.message.empty()) << "seed " << seed;
            ASSERT_FALSE(finding.where.path.empty()) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace cgw::test
