// Every rule has a directory tests/data/checks/<rule name>: bad.toml breaks it and nothing else, expected.txt
// holds the finding, good.toml is the same file mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "check/file_checker.hpp"
#include "check/findings_text.hpp"
#include "diagnostic/rules.hpp"
#include "diagnostic/rules/files.hpp"
#include "support/golden.hpp"
#include "toml/document.hpp"

namespace cgw::check {
namespace {

// No file in the repository can show these: one needs a file that cannot be opened (tested with the driver),
// the other one of more than 4 MiB (below).
const std::set<std::string_view> rules_without_directory = {"file-unreadable", "file-too-large"};

std::filesystem::path directory_of(const std::string& rule) {
    return std::filesystem::path(CGW_TEST_DATA) / "checks" / rule;
}

diagnostic::Findings findings_of(const std::string& rule, const std::string& file) {
    const std::filesystem::path directory = directory_of(rule);
    parameter::Catalogue catalogue(catalogue::shipped_rows());
    return test::check_text(test::read_text(directory / file), file, directory, catalogue).findings;
}

std::vector<std::string> rule_names() {
    std::vector<std::string> names;
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        // Of tables: tests/input and tests/authoring. Of scenario files: tests/scenario. Of firmware files:
        // tests/firmware_file. Of EDS and DCF: tests/eds. Of XDD and XDC: tests/xdd. Of CAN databases:
        // tests/dbc. Of a bus: tests/network. Of frames and logs: tests/signals, tests/traffic.
        const bool of_other_files = rule->code >= "E05";
        if (!of_other_files && !rules_without_directory.contains(rule->name)) {
            names.emplace_back(rule->name);
        }
    }
    return names;
}

class RuleData : public testing::TestWithParam<std::string> {};

TEST_P(RuleData, bad_file_breaks_this_rule_only_and_as_expected) {
    ASSERT_TRUE(std::filesystem::exists(directory_of(GetParam()) / "bad.toml"));
    const diagnostic::Findings findings = findings_of(GetParam(), "bad.toml");
    ASSERT_EQ(findings.all().size(), 1U) << test::findings_text(findings);
    EXPECT_EQ(findings.all()[0].rule->name, GetParam());
    EXPECT_EQ(findings.all()[0].where.path, "bad.toml");
    test::expect_golden("checks/" + GetParam() + "/expected.txt", test::findings_text(findings));
}

TEST_P(RuleData, good_file_has_no_finding) {
    ASSERT_TRUE(std::filesystem::exists(directory_of(GetParam()) / "good.toml"));
    const diagnostic::Findings findings = findings_of(GetParam(), "good.toml");
    EXPECT_EQ(test::findings_text(findings), "");
}

INSTANTIATE_TEST_SUITE_P(Rules, RuleData, testing::ValuesIn(rule_names()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(RuleDirectories, belong_to_rules) {
    const std::vector<std::string> names = rule_names();
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(CGW_TEST_DATA) / "checks")) {
        const std::string name = entry.path().filename().string();
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name << " names no rule";
    }
}

TEST(FileTooLarge, is_reported_for_text_of_more_than_4_mib) {
    parameter::Catalogue catalogue(catalogue::shipped_rows());
    const std::string text(toml::maximum_file_size + 1, '\n');
    const test::CheckedText checked = test::check_text(text, "large.toml", {}, catalogue);
    ASSERT_EQ(checked.findings.all().size(), 1U);
    EXPECT_EQ(checked.findings.all()[0].rule, &diagnostic::rules::file_too_large);
    EXPECT_FALSE(checked.usable);
}

}  // namespace
}  // namespace cgw::check
