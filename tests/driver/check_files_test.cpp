#include "driver/check_files.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cgw::driver {
namespace {

std::vector<std::string> many_paths() {
    std::vector<std::string> paths;
    for (int i = 0; i < 60; ++i) {
        paths.emplace_back(i % 3 == 0   ? CGW_SAMPLES "/genset.toml"
                           : i % 3 == 1 ? CGW_TEST_DATA "/checks/value-range/bad.toml"
                                        : "missing-" + std::to_string(i) + ".toml");
    }
    return paths;
}

// What matters of each result, in the order of take().
std::vector<std::string> results(unsigned threads) {
    std::vector<std::string> lines;
    check_files(many_paths(), threads, [&](CheckedFile&& file) {
        lines.push_back(file.path + (file.valid() ? " valid" : file.unreadable ? " unreadable" : " refused"));
        for (const diagnostic::Diagnostic& finding : file.findings.all()) {
            lines.back() += " " + finding.message;
        }
    });
    return lines;
}

}  // namespace

TEST(CheckFiles, gives_the_same_in_order_whatever_the_number_of_threads) {
    const std::vector<std::string> one = results(1);
    ASSERT_EQ(one.size(), many_paths().size());
    EXPECT_NE(one[0].find("genset.toml valid"), std::string::npos);
    EXPECT_NE(one[1].find(" refused "), std::string::npos);
    EXPECT_NE(one[2].find("missing-2.toml unreadable"), std::string::npos);
    for (const unsigned threads : {0U, 2U, 3U, 16U, 256U}) {
        EXPECT_EQ(results(threads), one) << threads;
    }
}

TEST(CheckFiles, without_paths_takes_nothing) {
    check_files({}, 4, [](CheckedFile&&) { FAIL(); });
}

TEST(CheckFiles, stops_when_the_taker_throws) {
    const std::vector<std::string> paths = many_paths();
    for (const unsigned threads : {1U, 4U}) {
        int taken = 0;
        EXPECT_THROW(check_files(paths, threads,
                                 [&](CheckedFile&&) {
                                     if (++taken == 3) {
                                         throw std::runtime_error("full");
                                     }
                                 }),
                     std::runtime_error);
        EXPECT_EQ(taken, 3);
    }
}

}  // namespace cgw::driver
