// Every artefact of every sample, byte for byte: tests/data/golden/<sample>/.
#include <gtest/gtest.h>

#include <cstdlib>

#include "driver/check_file.hpp"
#include "driver/outputs.hpp"
#include "driver/plant.hpp"
#include "support/golden.hpp"

namespace cgw::driver {
namespace {

class Golden : public testing::TestWithParam<std::string> {};

CheckedFile sample(const std::string& name) {
    unsetenv("SOURCE_DATE_EPOCH");  // a packager's date is not in the golden files
    return check_file(CGW_SAMPLES "/" + name + ".toml");
}

}  // namespace

TEST_P(Golden, artefacts_are_unchanged) {
    const CheckedFile file = sample(GetParam());
    ASSERT_TRUE(file.valid());
    const auto plant = Plant::make(file);
    for (const Artefact& artefact : build_artefacts(plant->view())) {
        test::expect_golden("golden/" + GetParam() + "/" + artefact.file_name,
                            std::string(artefact.content.begin(), artefact.content.end()));
    }
}

TEST_P(Golden, text_table_is_unchanged_and_fits_80_columns) {
    const CheckedFile file = sample(GetParam());
    ASSERT_TRUE(file.valid());
    emit::Options options;
    options.format = "text";
    const auto plant = Plant::make(file);
    const base::Bytes bytes = emit::find_emitter("pdo-table")->emit(plant->view(), options);
    const std::string text(bytes.begin(), bytes.end());
    test::expect_golden("golden/" + GetParam() + "/pdo-table.txt", text);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 80U) << line;
    }
}

// What build leaves out, for the partner's program: golden/<sample>/partner/.
TEST_P(Golden, partners_half_is_unchanged) {
    constexpr std::pair<std::string_view, std::string_view> files[] = {{"c-header", "partner.h"},
                                                                       {"structured-text", "partner.st"},
                                                                       {"stx", "partner.stx"},
                                                                       {"python-canopen", "partner.py"},
                                                                       {"points", "points.csv"}};
    const CheckedFile file = sample(GetParam());
    ASSERT_TRUE(file.valid());
    const auto plant = Plant::make(file);
    for (const auto& [emitter, name] : files) {
        const base::Bytes bytes = emit::find_emitter(emitter)->emit(plant->view(), {});
        test::expect_golden("golden/" + GetParam() + "/partner/" + std::string(name),
                            std::string(bytes.begin(), bytes.end()));
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, Golden, testing::Values("minimal", "genset", "manual-example"),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace cgw::driver
