#include "eds_check/fix.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "diagnostic/rules/eds_check.hpp"
#include "eds_check/checked.hpp"
#include "support/valid_data_sheet.hpp"

namespace cgw::eds_check {
namespace {

const Options as_example{.file_name = "example.eds"};

Fixed fixed_of(const std::string& text) {
    return fix(text, "example.eds", as_example);
}

bool is_repairable(const diagnostic::Diagnostic& finding) {
    const Check* const row = find_check(finding.rule);
    return row != nullptr && row->repair != nullptr;
}

// Lines of the valid sheet, some of them broken in ways that repairs mend, others in ways that they must not.
std::string broken_sheet(std::mt19937& random) {
    const std::vector<std::string_view> faults{
        "[1000]\n#the profile\n",
        "[1000]\nDataType =0x0007\n",
        "[2001]\nSubNumber=9\n",
        "[2001]\n; SubNumber=\n",
        "[2001]\nSubNumber=\n",
        "[2000]\n; ObjectType=\n",
        "[2000]\nAccessType=RwW\n",
        "[2000]\nDefaultValue=005\n",
        "[2000]\nDefaultValue=010\n",
        "[2000]\nDefaultValue=0x0x5\n",
        "[2000]\nDefaultValue=5UL\n",
        "[1800sub1]\nDefaultValue=0x180+$NODEID\n",
        "[1800sub1]\nDefaultValue=$nodeid + 384\n",
        "[1018]\nObjectType=0x8\n",
        "[FileInfo]\nFileName=other.eds\nEDSVersion=4\n",
        "[FileInfo]\nCreationTime=00:00am\nModificationTime=never\n",
        "[FileInfo]\nCreationDate=3-Feb-2024\nModificationDate=2024-02-03\n",
        "[DeviceInfo]\nNrOfRXPDO=7\nnroftxpdo=0\n; NrOfTXPDO=\n",
        "[DeviceInfo]\nVendorNumber=0\nRevisionNumber=0\n",
        "[DeviceInfo]\nSimpleBoot-upMaster=0\n; SimpleBootUpMaster=\n",
        "[Comments]\nLines=7\n",
        "[ManufacturerObjects]\nSupportedObjects=4\n7=0x2001\n9=0x2001\n; 2=\n",
        "[DeviceCommissioning]\nNodeID=7\n",
        "[2000]\nUnit=rpm\n",
        "[1A00sub1]\nDefaultValue=0x20010108\n"};
    std::string fragment;
    for (const std::string_view fault : faults) {
        fragment += random() % 4 == 0 ? fault : "";
    }
    return test::data_sheet_with(fragment);
}

}  // namespace

TEST(Fix, leaves_a_sheet_without_findings_as_it_is) {
    const std::string text(test::valid_data_sheet);
    const Fixed fixed = fixed_of(text);
    EXPECT_EQ(fixed.text, text);
    EXPECT_TRUE(fixed.repairs.empty());
    EXPECT_TRUE(fixed.doubts.all().empty());
}

TEST(Fix, is_idempotent_and_leaves_no_finding_that_it_could_mend) {
    std::mt19937 random(20061);
    for (int round = 0; round < 80; ++round) {
        const std::string text = broken_sheet(random);
        const Fixed once = fixed_of(text);
        ASSERT_TRUE(once.doubts.all().empty()) << text << test::as_lines(once.doubts);
        const Fixed twice = fixed_of(once.text);
        ASSERT_EQ(twice.text, once.text);
        ASSERT_TRUE(twice.repairs.empty()) << text;
        // What is left of rules with a repair is what can be meant in more than one way.
        const diagnostic::Findings left = test::checked(once.text);
        for (const diagnostic::Diagnostic& finding : left.all()) {
            const bool ambiguous = finding.message.find("`never`") != std::string::npos ||
                                   finding.message.find("`2024-02-03`") != std::string::npos ||
                                   finding.message.find("RevisionNumber") != std::string::npos;
            ASSERT_TRUE(!is_repairable(finding) || ambiguous) << test::as_lines(left) << text;
        }
    }
}

TEST(Fix, does_not_change_the_device_that_the_sheet_describes) {
    std::mt19937 random(20062);
    for (int round = 0; round < 60; ++round) {
        const std::string text = broken_sheet(random);
        const eds::Document before(text);
        const eds::Document after(fixed_of(text).text);
        diagnostic::Findings unused;
        dictionary::Dictionary was = eds::read(before, "example.eds", unused).dictionary;
        const dictionary::Dictionary is = eds::read(after, "example.eds", unused).dictionary;
        was.file = is.file;
        was.device.receive_pdos = is.device.receive_pdos;
        was.device.transmit_pdos = is.device.transmit_pdos;
        was.device.vendor_number = is.device.vendor_number;  // 0 where 1018h says it
        for (std::size_t i = 0; i < was.objects.size(); ++i) {
            was.objects[i].code = is.objects[i].code;  // ARRAY where CiA 301 has RECORD
        }
        ASSERT_EQ(was, is) << text;
    }
}

TEST(Fix, changes_only_the_lines_it_tells) {
    const std::string text =
        test::data_sheet_with("[1800sub1]\nDefaultValue=0x180+$NODEID\n[2001]\nSubNumber=2\n");
    const Fixed fixed = fixed_of(text);
    ASSERT_EQ(fixed.repairs.size(), 2U);
    const eds::Document before(text);
    const eds::Document after(fixed.text);
    ASSERT_EQ(before.lines().size(), after.lines().size());
    for (std::uint32_t line = 0; line < before.lines().size(); ++line) {
        const bool told =
            std::any_of(fixed.repairs.begin(), fixed.repairs.end(),
                        [&](const Repaired& repair) { return repair.where.range.start.line == line + 1; });
        EXPECT_EQ(before.view(before.line_span(line)) != after.view(after.line_span(line)), told) << line;
    }
}

TEST(Fix, keeps_line_ends_and_what_it_does_not_know) {
    const std::string text =
        "\xEF\xBB\xBF[1000]\r\nParameterName=Ger\xE4t\r\nDataType =0x0007\n\n\tnothing\r[x";
    const Fixed refused = fixed_of(text);
    EXPECT_EQ(refused.text, text);  // a header that is not closed
    const Fixed fixed = fixed_of(text + "]");
    EXPECT_NE(fixed.text.find("ParameterName=Ger\xE4t\r\n"), std::string::npos);
    EXPECT_NE(fixed.text.find("DataType=0x0007\n\n\tnothing\r[x]"), std::string::npos);
    EXPECT_TRUE(fixed.text.starts_with("[1000]\r\n"));
}

TEST(Fix, tells_places_in_the_text_as_it_was) {
    const std::string text =
        test::data_sheet_with("[1000]\n; ObjectType=\n[1001]\n; ObjectType=\n[2001]\nSubNumber=2\n");
    const Fixed fixed = fixed_of(text);
    ASSERT_EQ(fixed.repairs.size(), 3U);
    const eds::Document before(text);
    const std::uint32_t line = fixed.repairs.back().where.range.start.line - 1;
    EXPECT_EQ(before.view(before.line_span(line)), "SubNumber=2");
}

TEST(Fix, repairs_nothing_where_it_is_not_certain_what_the_sheet_says) {
    for (const std::string_view doubt :
         {"[2000]\nAccessType=RWW\nDataType=0x0006\nDataType=0x0007\n", "[2000\nAccessType=RWW\n",
          "[2000]\nAccessType=RWW\n[2000]\nAccessType=ro\n",
          "[ManufacturerObjects]\nSupportedObjects=2\n1=0x2000\n1=0x2001\n[2000]\nAccessType=RWW\n",
          "[DeviceComissioning]\nNodeID=05\n[DeviceCommissioning]\nNodeID=6\n"}) {
        const Fixed fixed = fixed_of(std::string(doubt));
        EXPECT_EQ(fixed.text, doubt);
        EXPECT_TRUE(fixed.repairs.empty()) << doubt;
        EXPECT_FALSE(fixed.doubts.all().empty()) << doubt;
    }
}

// The number is right, and a section is missing.
TEST(Fix, leaves_numbers_alone_that_something_else_in_the_sheet_confirms) {
    const std::string sub_missing =
        "[2000]\nParameterName=A\nObjectType=0x8\nSubNumber=3\n"
        "[2000sub0]\nParameterName=Highest\nDataType=0x0005\nAccessType=ro\nDefaultValue=2\n"
        "[2000sub1]\nParameterName=One\nDataType=0x0005\nAccessType=ro\n";
    EXPECT_EQ(fixed_of(sub_missing).text.find("SubNumber=2"), std::string::npos);
    const std::string pdo_missing =
        "[DeviceInfo]\nNrOfRXPDO=1\n[OptionalObjects]\nSupportedObjects=1\n1=0x1400\n";
    EXPECT_NE(fixed_of(pdo_missing).text.find("NrOfRXPDO=1"), std::string::npos);
    EXPECT_NE(fixed_of("[DeviceInfo]\nNrOfRXPDO=1\n").text.find("NrOfRXPDO=0"), std::string::npos);
}

// The second entry may have been meant for the object that is in no list.
TEST(Fix, leaves_lists_alone_that_can_be_meant_in_two_ways) {
    const std::string object = "ParameterName=A\nDataType=0x0005\nAccessType=ro\n";
    const std::string list = "[ManufacturerObjects]\nSupportedObjects=2\n1=0x2000\n";
    const std::string objects = "[2000]\n" + object;
    EXPECT_EQ(fixed_of(list + "2=0x2000\n" + objects).text.find("2=0x2000"), std::string::npos);
    EXPECT_NE(fixed_of(list + "2=0x2000\n" + objects + "[2001]\n" + object).text.find("2=0x2000"),
              std::string::npos);
    EXPECT_NE(fixed_of(list + objects).text.find("SupportedObjects=1\n"), std::string::npos);
    EXPECT_NE(fixed_of(list + "0x2=0x2001\n" + objects).text.find("SupportedObjects=2\n"), std::string::npos);
}

TEST(Fix, writes_only_file_names_that_an_eds_can_hold) {
    const std::string text = test::data_sheet_with("[FileInfo]\nFileName=other.eds\n");
    for (const std::string_view name : {"a;b.eds", "ger\xC3\xA4t.eds", " a.eds", "a\nb.eds"}) {
        EXPECT_EQ(fix(text, "a.eds", {.file_name = std::string(name)}).text, text) << name;
    }
    EXPECT_EQ(fix(text, "a.eds", {.file_name = std::string(400, 'a')}).text, text);
    EXPECT_NE(fix(text, "a.eds", {.file_name = "two words.eds"}).text.find("FileName=two words.eds\n"),
              std::string::npos);
}

// A list whose entries all stand there twice, with numbers that all are wrong.
TEST(Fix, is_linear_in_the_length_of_a_list) {
    constexpr unsigned entries = 30'000;
    std::string text = "[OptionalObjects]\nSupportedObjects=1\n";
    for (unsigned i = 0; i < entries; ++i) {
        text += fmt::format("{}=0x{:04X}\n", 7 * (entries - i), 0x1000 + i / 2);
    }
    const auto begin = std::chrono::steady_clock::now();
    const Fixed fixed = fixed_of(text);
    EXPECT_EQ(test::count_of(test::checked(fixed.text), diagnostic::rules::eds_listed_twice), 0U);
    EXPECT_EQ(test::count_of(test::checked(fixed.text), diagnostic::rules::eds_list_numbers), 0U);
    EXPECT_NE(fixed.text.find(fmt::format("SupportedObjects={}\n", entries / 2)), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));  // with sanitizers
}

TEST(Fix, mends_more_findings_of_a_kind_than_are_told) {
    std::string fragment;
    for (unsigned index = 0x3000; index < 0x3000 + 3 * eds::most_findings; ++index) {
        fragment += fmt::format("[{:04X}]\nParameterName=Spare\nDataType=0x0007\nAccessType=RO\n", index);
    }
    const Fixed fixed = fixed_of(test::data_sheet_with(fragment));
    EXPECT_EQ(fixed.repairs.size(), 2 * 3 * eds::most_findings);
    EXPECT_EQ(fixed.text.find("=RO"), std::string::npos);
}

}  // namespace cgw::eds_check
