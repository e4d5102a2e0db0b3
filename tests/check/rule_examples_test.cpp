// The examples in the rules themselves, as every explanation shows them: on top of a valid file `bad` gives
// the finding and `good` does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "check/file_checker.hpp"
#include "check/findings_text.hpp"
#include "check/overlay.hpp"

namespace cgw::check {
namespace {

using diagnostic::Rule;

constexpr std::string_view valid_file =
    "format = 1\n"
    "title = \"example\"\n"
    "[governor]\n"
    "[governor.parameters]\n"
    "401 = 1\n"
    "403 = 2\n"
    "416 = 250\n"
    "4406 = 1\n"
    "[gateway]\n"
    "[gateway.parameters]\n"
    "401 = 2\n"
    "402 = 1\n"
    "416 = 250\n"
    "4400 = 1\n"
    "426 = 125\n"
    "427 = 1\n"
    "429 = 800\n";

diagnostic::Findings findings_with(std::string_view fragment) {
    parameter::Catalogue catalogue(catalogue::shipped_rows());
    const auto directory = std::filesystem::path(CGW_TEST_DATA) / "checks" / "catalogue-unreadable";
    const std::string text = test::overlaid(valid_file, fragment);
    return test::check_text(text, "example.toml", directory, catalogue).findings;
}

bool has(const diagnostic::Findings& findings, const Rule& rule) {
    return std::any_of(findings.all().begin(), findings.all().end(),
                       [&](const diagnostic::Diagnostic& finding) { return finding.rule == &rule; });
}

// No printed text can show these.
bool cannot_be_shown(const Rule& rule) {
    return rule.name == "file-unreadable" || rule.name == "file-too-large" || rule.name == "file-not-utf8";
}

class RuleExamples : public testing::TestWithParam<const Rule*> {};

TEST_P(RuleExamples, show_the_rule_broken_and_kept) {
    const Rule& rule = *GetParam();
    if (rule.code.starts_with("E05")) {
        GTEST_SKIP() << "broken by tables and copies: tests/input, tests/authoring";
    }
    if (cannot_be_shown(rule)) {
        EXPECT_EQ(rule.bad, "");
        EXPECT_EQ(rule.good, "");
        return;
    }
    const diagnostic::Findings bad = findings_with(rule.bad);
    EXPECT_TRUE(has(bad, rule)) << rule.bad << test::findings_text(bad);
    EXPECT_EQ(bad.all().size(), 1U) << rule.bad << test::findings_text(bad);
    const diagnostic::Findings good = findings_with(rule.good);
    EXPECT_EQ(test::findings_text(good), "") << rule.good;
    EXPECT_NE(rule.good, "") << rule.name;
}

INSTANTIATE_TEST_SUITE_P(Rules, RuleExamples, testing::ValuesIn(diagnostic::all_rules()),
                         [](const auto& test) {
                             std::string name(test.param->name);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(RuleExampleFile, has_no_findings_itself) {
    EXPECT_EQ(test::findings_text(findings_with("")), "");
}

}  // namespace
}  // namespace cgw::check
