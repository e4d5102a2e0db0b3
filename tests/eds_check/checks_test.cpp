#include "eds_check/checks.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "diagnostic/rules.hpp"
#include "diagnostic/rules/eds.hpp"
#include "diagnostic/rules/eds_check.hpp"
#include "diagnostic/rules/plant.hpp"
#include "eds_check/checked.hpp"
#include "support/valid_data_sheet.hpp"

namespace cgw::eds_check {
namespace {

namespace rules = diagnostic::rules;
using diagnostic::Level;

diagnostic::Findings checked_with(std::string_view fragment, Options options = {}) {
    return test::checked(test::data_sheet_with(fragment), "example.eds", std::move(options));
}

}  // namespace

TEST(CheckTable, has_one_row_for_each_rule) {
    std::set<const diagnostic::Rule*> seen;
    for (const Check& row : all_checks()) {
        EXPECT_TRUE(seen.insert(row.rule).second) << row.rule->name;
        EXPECT_EQ(find_check(row.rule), &row);
    }
    for (const diagnostic::Rule* rule : diagnostic::all_rules()) {
        EXPECT_TRUE(rule->code < "E0820" || rule->code >= "E0900" || seen.contains(rule)) << rule->name;
    }
    EXPECT_EQ(find_check(&rules::node_id_duplicate), nullptr);
}

TEST(StrictCheck, makes_errors_of_what_strict_importers_refuse) {
    constexpr std::string_view vendor_key = "[2000]\nUnit=rpm\n";
    EXPECT_EQ(checked_with(vendor_key).all().front().level(), Level::note);
    EXPECT_EQ(checked_with(vendor_key, {.strict = true}).all().front().level(), Level::error);
    constexpr std::string_view line_end = "[1000]\n#the profile\n";
    EXPECT_EQ(checked_with(line_end, {.strict = true}).all().front().level(), Level::warning);
}

TEST(StrictCheck, makes_errors_of_what_the_reader_has_found) {
    const diagnostic::Findings findings =
        checked_with("[1800sub1]\nDefaultValue=0x180+$NODEID\n", {.strict = true});
    ASSERT_EQ(findings.all().size(), 1U);
    EXPECT_EQ(findings.all().front().rule, &rules::eds_formula);
    EXPECT_EQ(findings.all().front().level(), Level::error);
}

TEST(StrictCheck, stays_strict_when_warnings_are_promoted) {
    diagnostic::Findings findings = checked_with("[2000]\nUnit=rpm\n", {.strict = true});
    findings.promote_warnings();
    EXPECT_TRUE(findings.has_errors());
}

TEST(IdentifierChecks, take_the_node_that_is_given_then_that_of_the_file) {
    constexpr std::string_view meeting = "[1800sub1]\nDefaultValue=0x205\n";  // RPDO1 of node 5
    EXPECT_EQ(test::count_of(checked_with(meeting), rules::eds_cob_id_twice), 0U);
    EXPECT_EQ(test::count_of(checked_with(meeting, {.node_id = 5}), rules::eds_cob_id_twice), 1U);
    EXPECT_EQ(test::count_of(checked_with(meeting, {.node_id = 6}), rules::eds_cob_id_twice), 0U);
    constexpr std::string_view of_node_5 = "[1800sub1]\nDefaultValue=0x205\n[DeviceComissioning]\nNodeID=5\n";
    EXPECT_EQ(test::count_of(checked_with(of_node_5), rules::eds_cob_id_twice), 1U);
    EXPECT_EQ(test::count_of(checked_with(of_node_5, {.node_id = 6}), rules::eds_cob_id_twice), 0U);
}

TEST(ConfiguredValues, count_in_mappings_and_identifiers) {
    constexpr std::string_view node = "[DeviceComissioning]\nNodeID=5\n";
    const std::string mapped = fmt::format("{}[1A00sub1]\nParameterValue=0x20020010\n", node);
    EXPECT_EQ(test::count_of(checked_with(mapped), rules::eds_mapped_absent), 1U);
    const std::string meeting = fmt::format("{}[1800sub1]\nParameterValue=0x205\n", node);
    EXPECT_EQ(test::count_of(checked_with(meeting), rules::eds_cob_id_twice), 1U);
    const std::string used = fmt::format("{}[1A00sub0]\nParameterValue=6\n", node);
    EXPECT_EQ(test::count_of(checked_with(used), rules::eds_mapped_count), 1U);
}

TEST(ModuleChecks, find_a_module_that_is_counted_and_one_that_is_not) {
    const auto lines = [](unsigned count) {
        return fmt::format("[SupportedModules]\nNrOfEntries={}\n[M2ModuleInfo]\nProductName=Inputs\n", count);
    };
    EXPECT_EQ(test::count_of(checked_with(lines(2)), rules::eds_module), 1U);
    EXPECT_EQ(test::count_of(checked_with(lines(1)), rules::eds_module), 2U);
    EXPECT_EQ(test::count_of(checked_with(lines(1'000'000)), rules::eds_module), 1U);
}

TEST(IdentifierChecks, pass_over_pdos_that_are_off) {
    const std::string off = "[1800sub1]\nDefaultValue=$NODEID+0x80000200\n";
    EXPECT_EQ(test::as_lines(checked_with(off)), "");
}

TEST(IdentifierChecks, have_the_free_and_the_predefined_identifiers_in_order) {
    for (const std::string_view value :
         {"$NODEID+0x180", "$NODEID+0x280", "$NODEID+0x480", "0x680", "0x6DF", "0x181", "0x2000FFFF"}) {
        const std::string fragment = fmt::format("[1800sub1]\nDefaultValue={}\n", value);
        EXPECT_EQ(test::as_lines(checked_with(fragment)), "") << value;
    }
    for (const std::string_view value : {"0", "0x7F", "$NODEID+0x100", "0x581", "0x600", "0x6E0", "0x77F"}) {
        const std::string fragment = fmt::format("[1800sub1]\nDefaultValue={}\n", value);
        EXPECT_EQ(checked_with(fragment).all().size(), 1U) << value << '\n'
                                                           << test::as_lines(checked_with(fragment));
    }
}

TEST(MappingChecks, take_the_value_of_the_node_before_the_default) {
    constexpr std::string_view node =
        "[DeviceComissioning]\nNodeID=5\n[1A00sub1]\nDefaultValue=0x20019910\nParameterValue=0x20010110\n";
    EXPECT_EQ(test::as_lines(checked_with(node)), "");
}

TEST(MappingChecks, pass_over_entries_that_are_not_in_use) {
    EXPECT_EQ(test::as_lines(checked_with("[1A00sub5]\nDefaultValue=0x99990110\n")), "");
}

TEST(MappingChecks, have_a_boolean_in_order_as_a_bit_and_as_a_byte) {
    for (const std::string_view bits : {"01", "08"}) {
        const std::string fragment = fmt::format(
            "[2000]\nDataType=0x0001\nDefaultValue=0\n[1600sub1]\nDefaultValue=0x200000{}\n", bits);
        EXPECT_EQ(test::as_lines(checked_with(fragment)), "");
    }
}

TEST(FileName, is_compared_only_when_it_is_known) {
    diagnostic::Findings findings;
    const eds::Document document{std::string(test::valid_data_sheet)};
    const eds::Sheet sheet = eds::read(document, "-", findings);
    check(document, sheet, "-", {}, findings);
    EXPECT_EQ(test::as_lines(findings), "");
    check(document, sheet, "-", {.file_name = "EXAMPLE.EDS"}, findings);
    EXPECT_EQ(test::as_lines(findings), "");
    check(document, sheet, "-", {.file_name = "examples.eds"}, findings);
    EXPECT_EQ(findings.all().size(), 1U);
}

TEST(CheckFindings, of_one_kind_are_counted_beyond_a_hundred) {
    std::string fragment = "[2000]\n";
    for (int i = 0; i < 150; ++i) {
        fragment += fmt::format("Colour{}=blue\n", i);
    }
    const diagnostic::Findings findings = checked_with(fragment);
    EXPECT_EQ(findings.all().size(), eds::most_findings + 1);
    EXPECT_EQ(findings.all().front().message, "50 more findings of this kind are not told one by one");
}

TEST(CheckFindings, take_an_empty_value_for_one_that_is_missing) {
    const std::string lines = test::as_lines(checked_with("[DeviceInfo]\nVendorName=\n"));
    EXPECT_NE(lines.find("E0835 eds-keys-absent: [DeviceInfo] lacks VendorName\n"), std::string::npos) << lines;
}

TEST(CheckFindings, tell_dummies_that_are_no_data_type) {
    for (const std::string_view key : {"Dummy00FF", "Dummy0000", "Dummyabcd", "Dummy5"}) {
        const diagnostic::Findings findings = checked_with(fmt::format("[DummyUsage]\n{}=1\n", key));
        ASSERT_EQ(findings.all().size(), 1U) << key;
        EXPECT_EQ(findings.all().front().rule->name, "eds-key-unknown");
    }
    EXPECT_TRUE(checked_with("[DummyUsage]\nDummy0005=1\nDummy001B=1\n").all().empty());
}

TEST(CheckFindings, are_none_of_bytes_that_are_no_sheet) {
    for (const std::string& bytes :
         {std::string(), std::string("\xFF\xFE[\0", 4), std::string("no section")}) {
        EXPECT_EQ(test::checked(bytes).all().size(), 1U);  // the reader's
    }
    for (const std::string text : {"<?xml version=\"1.0\"?>\n<a/>\n", "\xEF\xBB\xBF\r\n<a>\n[b]\n</a>\n"}) {
        EXPECT_EQ(test::checked(text).all().front().message,
                  "the file is XML, no EDS; cgw convert makes an EDS of one of CiA 311");
    }
}

// Twice as much takes about twice as long: no file makes a check quadratic.
TEST(CheckTime, is_linear_for_files_made_to_be_slow) {
    const auto seconds = [](const std::string& text) {
        const auto begin = std::chrono::steady_clock::now();
        test::checked(text);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const auto many = [](std::size_t count, auto line) {
        std::string text = "[DeviceInfo]\n";
        for (std::size_t i = 0; i < count; ++i) {
            text += line(i);
        }
        return text;
    };
    const std::vector<std::string (*)(std::size_t)> kinds{
        [](std::size_t i) { return fmt::format("Kez{}=1\n", i); },
        [](std::size_t) { return std::string("NrOfRXPDO=1\n"); },
        [](std::size_t i) { return fmt::format("[{:04X}]\n", 0x2000 + i % 0x4000); },
        [](std::size_t i) { return fmt::format("[2000sub{:X}]\nParameterName=a\n", i % 256); },
        [](std::size_t i) { return fmt::format("[OptionalObjects]\n{}=0x1000\n", i); },
        [](std::size_t i) { return fmt::format("[Section {}]\n", i); }};
    constexpr std::size_t count = 2'000;
    for (const auto kind : kinds) {
        const double once = seconds(many(count, kind));
        const double more = seconds(many(8 * count, kind));
        EXPECT_LT(more, 8 * 4 * once + 0.5) << many(3, kind);
    }
}

}  // namespace cgw::eds_check
