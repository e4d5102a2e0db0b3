// A hundred small files that imitate what real ones have: what is found in each, with its place, and what is
// repaired, stand in tests/data/eds_check/. The name of a file begins with the code that it is about.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <vector>

#include "eds_check/checked.hpp"
#include "eds_check/fix.hpp"
#include "support/golden.hpp"

namespace cgw::eds_check {
namespace {

std::vector<std::filesystem::path> fixtures() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(CGW_FIXTURES)) {
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string code_of(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    return name.substr(0, name.find('-'));
}

class Fixture : public testing::TestWithParam<std::filesystem::path> {};

}  // namespace

TEST_P(Fixture, shows_the_finding_it_is_named_after) {
    const std::string name = GetParam().filename().string();
    const diagnostic::Findings findings = test::checked(test::read_text(GetParam()), name);
    const std::string code = code_of(GetParam());
    if (code == "none") {
        EXPECT_EQ(test::as_lines(findings), "");
    } else if (code.starts_with('E')) {
        EXPECT_TRUE(std::any_of(findings.all().begin(), findings.all().end(), [&](const auto& finding) {
            return finding.rule->code == code;
        })) << test::as_lines(findings);
    }
}

TEST_P(Fixture, has_nothing_left_to_repair_once_it_is_repaired) {
    const std::string name = GetParam().filename().string();
    const Fixed once = fix(test::read_text(GetParam()), name, {.file_name = name});
    const Fixed twice = fix(once.text, name, {.file_name = name});
    EXPECT_EQ(twice.text, once.text);
    EXPECT_TRUE(twice.repairs.empty());
}

INSTANTIATE_TEST_SUITE_P(Files, Fixture, testing::ValuesIn(fixtures()), [](const auto& instance) {
    std::string name = instance.param.filename().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    return name;
});

TEST(Fixtures, give_these_findings) {
    std::string text;
    for (const std::filesystem::path& path : fixtures()) {
        const std::string name = path.filename().string();
        text += fmt::format("{}\n{}\n", name, test::as_lines(test::checked(test::read_text(path), name)));
    }
    test::expect_golden("eds_check/findings.txt", text);
}

TEST(Fixtures, are_repaired_like_this) {
    std::string text;
    for (const std::filesystem::path& path : fixtures()) {
        const std::string name = path.filename().string();
        const Fixed fixed = fix(test::read_text(path), name, {.file_name = name});
        std::string lines;
        for (const Repaired& repair : fixed.repairs) {
            const diagnostic::Position& at = repair.where.range.start;
            lines += fmt::format("{}:{} {} {}\n", at.line, at.column, repair.rule->code, repair.what);
        }
        lines += fixed.doubts.all().empty() ? "" : "refused\n";
        text += lines.empty() ? "" : fmt::format("{}\n{}\n", name, lines);
    }
    test::expect_golden("eds_check/repairs.txt", text);
}

TEST(Fixtures, are_at_least_sixty_and_cover_every_check_that_a_file_can_break) {
    std::set<std::string> codes;
    for (const std::filesystem::path& path : fixtures()) {
        codes.insert(code_of(path));
    }
    EXPECT_GE(fixtures().size(), 60U);
    for (const Check& row : all_checks()) {
        if (row.run != nullptr) {
            EXPECT_TRUE(codes.contains(std::string(row.rule->code)))
                << row.rule->code << ' ' << row.rule->name;
        }
    }
}

}  // namespace cgw::eds_check
