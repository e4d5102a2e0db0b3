#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

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

// Code and message of every finding, without the places, sorted.
std::vector<std::string> findings(const driver::CheckedFile& file) {
    std::vector<std::string> all;
    for (const diagnostic::Diagnostic& finding : file.findings.all()) {
        all.push_back(std::string(finding.rule->code) + " " + finding.message + " | " + finding.help);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Every artefact in one string, empty when the plant is not valid.
std::string artefacts(const driver::CheckedFile& file) {
    std::string all;
    if (!file.valid()) {
        return all;
    }
    const auto plant = driver::Plant::make(file);
    for (const driver::Artefact& artefact : driver::build_artefacts(plant.value().view())) {
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
        }
    }
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
