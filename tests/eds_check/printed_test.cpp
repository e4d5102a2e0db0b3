// The data sheet that the manual prints (chapter 10): all its faults (D41), and what is repaired of them.
#include <gtest/gtest.h>

#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/checked.hpp"
#include "eds_check/fix.hpp"
#include "support/golden.hpp"

namespace cgw::eds_check {
namespace {

const std::string name = "CANopenGateway.eds";

std::string printed() {
    return test::read_text(std::filesystem::path(CGW_TEST_DATA) / "eds/printed.eds");
}

}  // namespace

TEST(PrintedDataSheet, is_told_its_faults) {
    test::expect_golden("eds_check/printed.txt", test::as_lines(test::checked(printed(), name)));
}

TEST(PrintedDataSheet, has_every_fault_of_ruling_41) {
    const diagnostic::Findings findings = test::checked(printed(), name);
    namespace rules = diagnostic::rules;
    EXPECT_EQ(test::count_of(findings, rules::eds_file_name), 1U);
    EXPECT_EQ(test::count_of(findings, rules::eds_number_form), 1U);
    EXPECT_EQ(test::count_of(findings, rules::eds_version), 1U);
    EXPECT_EQ(test::count_of(findings, rules::eds_time), 2U);
    EXPECT_EQ(test::count_of(findings, rules::eds_spelling), 2U);
    EXPECT_EQ(test::count_of(findings, rules::eds_key_case), 5U);
    EXPECT_EQ(test::count_of(findings, rules::eds_standard_code), 22U);
}

TEST(PrintedDataSheet, is_mended_but_for_what_it_does_not_say) {
    const Fixed fixed = fix(printed(), name, {.file_name = name});
    test::expect_golden("eds_check/printed-repaired.txt", test::as_lines(test::checked(fixed.text, name)));
}

}  // namespace cgw::eds_check
