// Golden files: tests compare with tests/data; CGW_UPDATE_GOLDEN=1 rewrites them, and CI refuses it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace cgw::test {

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// "7:\n  golden: …\n  actual: …" of the first line that differs, whole artefacts are too long to print.
inline std::string first_difference(const std::string& expected, const std::string& actual) {
    std::istringstream golden_lines(expected);
    std::istringstream actual_lines(actual);
    std::string golden;
    std::string now;
    for (int number = 1;; ++number) {
        const bool more_golden = static_cast<bool>(std::getline(golden_lines, golden));
        const bool more_actual = static_cast<bool>(std::getline(actual_lines, now));
        if (golden != now || more_golden != more_actual || !more_golden) {
            return std::to_string(number) + ":\n  golden: " + (more_golden ? golden : "(end)") +
                   "\n  actual: " + (more_actual ? now : "(end)");
        }
    }
}

// `relative` is below tests/data.
inline void expect_golden(const std::string& relative, const std::string& actual) {
    const std::filesystem::path path = std::filesystem::path(CGW_TEST_DATA) / relative;
    if (std::getenv("CGW_UPDATE_GOLDEN") != nullptr) {
        ASSERT_EQ(std::getenv("CI"), nullptr) << "golden files are not updated in CI";
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << actual;
        return;
    }
    ASSERT_TRUE(std::filesystem::exists(path)) << path << " is missing; run with CGW_UPDATE_GOLDEN=1";
    const std::string expected = read_text(path);
    if (expected != actual) {
        ADD_FAILURE() << path << " differs, first in line " << first_difference(expected, actual)
                      << "; CGW_UPDATE_GOLDEN=1 rewrites it";
    }
}

}  // namespace cgw::test
