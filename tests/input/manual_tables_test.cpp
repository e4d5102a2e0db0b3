// The tables that the manual prints, in every separation.
#include "input/printed_table.hpp"

#include <filesystem>

#include "support/golden.hpp"

namespace cgw::input {
namespace {

std::string without_dots(const std::string& table) {
    std::string text;
    for (std::size_t at = 0; at < table.size();) {
        const std::size_t end = table.find('\n', at) + 1;
        const std::string line = table.substr(at, end - at);
        text += line.find(':') == std::string::npos || line.find_first_of("1A-") < 2 ? line : "";
        at = end;
    }
    return text;
}

class ManualTables : public testing::TestWithParam<const char*> {
  protected:
    static std::string table(const std::string& device) {
        return test::read_text(std::filesystem::path(CGW_TEST_DATA) / "tables" /
                               fmt::format("manual-{}.{}", device, GetParam()));
    }
};

constexpr std::string_view governor_values =
    "400=1.0 401=1 403=1 416=250 827=1 835=-5 900=1 901=2 906=7 917=12 4406=1 4416=0 4827=3 4835=3 4900=3 "
    "4901=3 4906=3 4917=3 14401=1 14402=0 16400=2000 16401=2031 16402=2300 16403=2330 16404=0 16405=0 "
    "16446=0 16447=0 16448=2905 16449=2908 16450=2917 16451=0 16460=16 16461=0 16462=200 16463=0 16464=0 "
    "16465=0 16466=0 16467=0 16468=0 16469=0 16470=0 16471=0 16472=100 16480=0 16481=100 16482=200 "
    "16483=1000";

TEST_P(ManualTables, of_the_governor_are_refused_for_their_dots_alone) {
    const Read result = read(table("governor"));
    EXPECT_EQ(result.findings.count(diagnostic::Level::error), 1U) << text_of(result.findings);
    EXPECT_NE(text_of(result.findings).find("dots stand for rows that are left out after 16405"),
              std::string::npos)
        << text_of(result.findings);
}

TEST_P(ManualTables, of_the_governor_are_read_with_a_note_for_each_misprint) {
    const Read result = read(without_dots(table("governor")));
    EXPECT_EQ(values_of(result.table), governor_values);
    std::string messages;
    for (const diagnostic::Diagnostic& finding : result.findings.all()) {
        messages += fmt::format("{} {}\n", finding.rule->code, finding.message);
    }
    EXPECT_EQ(
        messages,
        "E0401 409 CanBaudrate is a misprint of the manual, read as 416 CanBaudrate\n"
        "E0401 4409 CanSegmentOrBaudrate is a misprint of the manual, read as 4416 CanSegmentOrBaudrate\n"
        "E0401 4901 ChanType_Setp1Ext is a misprint of the manual, read as 4901 ChanType_Setp2Ext\n");
}

TEST_P(ManualTables, of_the_gateway_are_read_without_their_measurements) {
    const Read result = read(table("gateway"), Device::gateway);
    EXPECT_EQ(values_of(result.table),
              "400=1.0 401=1 402=1 416=250 426=125 427=1 428=127 429=1000 430=100 4400=1 4416=0 4426=0 "
              "16404=0x282 16407=0x382 16411=0x3 16415=0x57F");
    ASSERT_EQ(result.findings.all().size(), 1U) << text_of(result.findings);
    EXPECT_EQ(result.findings.all()[0].message,
              "measurements are skipped: 2410 CanDCNodeState31to16, 2411 CanDCNodeState15to01, "
              "2424 CanPCNodeState31to16, 2425 CanPCNodeState15to01");
}

INSTANTIATE_TEST_SUITE_P(Separated, ManualTables,
                         testing::Values("tabs.txt", "semicolons.csv", "bars.md", "blanks.txt"),
                         [](const auto& instance) {
                             const std::string name = instance.param;
                             return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace cgw::input
