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
    EXPECT_EQ(read_text(path), actual) << "golden file " << path << "; CGW_UPDATE_GOLDEN=1 rewrites it";
}

}  // namespace cgw::test
