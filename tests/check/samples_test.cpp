// The samples, and what one slip of the finger in the genset's file gives: one finding, at the slip.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "check/file_checker.hpp"
#include "check/findings_text.hpp"
#include "config/configuration.hpp"
#include "support/golden.hpp"

namespace cgw::check {
namespace {

using diagnostic::Level;
using test::findings_text;

std::string sample(const std::string& name) {
    return test::read_text(std::filesystem::path(CGW_SAMPLES) / name);
}

class Samples : public testing::Test {
  protected:
    test::CheckedText check_sample(const std::string& name) {
        return test::check_text(sample(name), name, CGW_SAMPLES, catalogue);
    }

    parameter::Catalogue catalogue{catalogue::shipped_rows()};
};

TEST_F(Samples, minimal_is_valid) {
    EXPECT_EQ(findings_text(check_sample("minimal.toml").findings), "");
}

TEST_F(Samples, minimal_cannot_lose_a_line) {
    const std::string text = sample("minimal.toml");
    std::size_t begin = 0;
    int lines = 0;
    while (begin < text.size()) {
        const std::size_t end = text.find('\n', begin) + 1;
        const std::string line = text.substr(begin, end - begin);
        if (line.find('=') != std::string::npos) {
            parameter::Catalogue rows(catalogue::shipped_rows());
            const std::string shorter = text.substr(0, begin) + text.substr(end);
            const auto findings = test::check_text(shorter, "minimal.toml", {}, rows).findings;
            EXPECT_EQ(findings.all().size(), 1U) << line << findings_text(findings);
            const bool is_heartbeat = line.starts_with("429");  // the one line that is advice
            EXPECT_EQ(findings.has_errors(), !is_heartbeat) << line << findings_text(findings);
            ++lines;
        }
        begin = end;
    }
    EXPECT_EQ(lines, 12);
}

TEST_F(Samples, genset_has_no_finding_at_all) {
    const test::CheckedText genset = check_sample("genset.toml");
    EXPECT_EQ(findings_text(genset.findings), "");
    EXPECT_TRUE(genset.configuration.decisions.empty());
    int transmit = 0;
    int receive = 0;
    for (const config::Pdo& pdo : genset.configuration.pdos) {
        int& count = pdo.direction == config::Direction::transmit ? transmit : receive;
        count += pdo.active ? 1 : 0;
    }
    EXPECT_EQ(transmit, 6);
    EXPECT_EQ(receive, 4);
    EXPECT_EQ(genset.configuration.heartbeat_producer.effective_us, 800000U);
    EXPECT_EQ(genset.configuration.heartbeat_consumer.effective_us, 2000000U);
}

TEST_F(Samples, genset_words_all_have_engineering_units) {
    const std::string text = sample("genset.toml");
    diagnostic::Findings findings;
    const input::ReadResult read = input::read_parameter_file(
        text, "genset.toml", catalogue, [](const std::string& name) { return base::failure(name); },
        findings);
    const config::Configuration configuration = config::resolve(read.file.settings, catalogue);
    ASSERT_EQ(configuration.analogue_outputs.size(), 12U);
    for (const config::AnalogueOutput& output : configuration.analogue_outputs) {
        EXPECT_TRUE(parameter::external_limits(*output.parameter, read.file.settings.governor))
            << parameter::label(*output.parameter);
    }
}

TEST_F(Samples, manual_example_has_no_error_and_resolves_as_printed) {
    const test::CheckedText example = check_sample("manual-example.toml");
    EXPECT_EQ(example.findings.count(Level::error), 0U) << findings_text(example.findings);
    EXPECT_EQ(example.configuration.tpdo(4).length(), 8);
    EXPECT_EQ(example.configuration.tpdo(16).length(), 6);
    EXPECT_EQ(example.configuration.tpdo(16).cob_id, 0x57F);
    EXPECT_EQ(example.configuration.governor_can.bit_rate_kbit, 250);
    EXPECT_EQ(example.configuration.highest_channel, 12);
    EXPECT_EQ(example.configuration.sensors.size(), 4U);
    EXPECT_EQ(example.configuration.decisions.size(), 7U);
}

// D35 applied to chapter 7: three monitoring times that trip, RPDO1 unmonitored, TPDO6 empty; three
// misprints, four times that become others, and TPDO16 linked to node 127. TPDO5, 8 and 12 are inactive, so
// nothing is said about 282h, 382h and 003h.
TEST_F(Samples, manual_example_has_the_warnings_and_notes_that_the_rulings_predict) {
    const test::CheckedText example = check_sample("manual-example.toml");
    EXPECT_EQ(example.findings.count(Level::warning), 5U);
    EXPECT_EQ(example.findings.count(Level::note), 8U);
    test::expect_golden("samples/manual-example.txt", findings_text(example.findings));
}

TEST_F(Samples, bad_ones_have_one_error_each) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(CGW_SAMPLES) / "bad")) {
        const std::string name = entry.path().filename().string();
        parameter::Catalogue rows(catalogue::shipped_rows());
        const auto findings = test::check_text(test::read_text(entry.path()), name, {}, rows).findings;
        EXPECT_EQ(findings.count(Level::error), 1U) << name << "\n" << findings_text(findings);
        test::expect_golden("samples/bad/" + entry.path().stem().string() + ".txt", findings_text(findings));
        ++files;
    }
    EXPECT_GE(files, 5);
}

struct Slip {
    std::string_view typed;     // occurs once in the file
    std::string_view mistaken;  // what stands there instead
    std::string_view rule;
    std::string_view place;  // the finding starts where this begins in `mistaken`
};

constexpr Slip slips[] = {
    {"format = 1\n", "format = 2\n", "format-unsupported", "2"},
    {"starboard\"\n", "starboard\n", "toml-syntax", ""},
    {"title = ", "titel = ", "key-unknown", "titel"},
    {"[gateway.parameters]", "[gatway.parameters]", "key-unknown", "gatway"},
    {"[gateway.parameters]", "[gateway.paramters]", "key-unknown", "paramters"},
    {"revision = 2\n", "revision = 2000\n", "key-value", "2000"},
    {"[network]\n", "[netwrk]\n", "key-unknown", "netwrk"},
    {"nodes = [1, 11]", "nodes = [1, 1]", "network-node-duplicate", "1]"},
    {"CanCMNodeNumber = 2", "CanCMNodeNumber = 3", "hzm-node-mismatch", "3"},
    {"CanCMNodeNumber = 2", "CanCMNodeNumber = 32", "value-range", "32"},
    {"HzmCanBaudrate = 250", "HzmCanBaudrate = 25", "value-range", "25"},
    {"HzmCanBaudrate = 250", "HzmCanBaudrat = 250", "parameter-unknown", "HzmCanBaudrat"},
    {"HzmCanCommDCon = 1", "HzmCanComDCon = 1", "parameter-unknown", "HzmCanComDCon"},
    {"HzmCanCommDCon = 1", "HzmCanCommDCon = 0", "communication-off", "0"},
    {"HzmCanCommDCon = 1", "HzmCanCommDCon = 2", "value-range", "2"},
    {"CanOpenMyNodeID = 12", "CanOpenMyNodID = 12", "parameter-unknown", "CanOpenMyNodID"},
    {"CanOpenMyNodeID = 12", "CanOpenMyNodeID = 1", "node-id-duplicate", ""},
    {"CanOpenMyNodeID = 12", "CanOpenMyNodeID = 11", "node-id-listed", "11"},
    {"CanOpenMyNodeID = 12", "CanOpenMyNodeID = 120.0", "value-type", "120.0"},
    {"CanOpenMyNodeID = 12", "CanOpenMyNodeID = 128", "value-range", "128"},
    {"CanOpenPartnerNodeID = 1\n", "CanOpenPartnerNodeID = 0\n", "heartbeat-partner-missing", ""},
    {"CanOpenPartnerNodeID = 1\n", "CanOpenPartnerNodeI = 1\n", "parameter-unknown", "CanOpenPartnerNodeI"},
    {"CanOpenPartnerNodeID = 1\n", "CanOpenPartnerNodeID = -1\n", "value-range", "-1"},
    {"[0x680, 0x681]", "[0x680, 0x680]", "cob-id-duplicate", "0x680]"},
    {"[0x680, 0x681]", "[0x680, 0x81]", "cob-id-foreign", "0x81"},
    {"[0x680, 0x681]", "[0x80, 0x681]", "cob-id-reserved", "0x80"},
    {"[0x680, 0x681]", "[0x680, 0x6811]", "value-range", "0x6811"},
    {"CanOpTPDO5-16ID = ", "CanOpTPDO5-6ID = ", "parameter-unknown", "CanOpTPDO5-6ID"},
    {"[125, 500, 1000]", "[125, 500, 10000]", "time-too-long", "10000"},
    {"[125, 500, 1000]", "[125, 500 1000]", "toml-syntax", "1000"},
    {"[2000, 2031, 2300, 2918]", "[2000, 2031, 2301, 2918]", "tpdo-parameter-unknown", "2301"},
    {"[2000, 2031, 2300, 2918]", "[3000, 2031, 2300, 2918]", "tpdo-parameter-bit", "3000"},
    {"FunctLoadEnable = -3", "FunctLoadEnable = -33", "switch-bit-range", "-33"},
    {"AssignIn_CurrentLoad = 9", "AssignIn_CurrentLoad = 99", "sensor-channel-range", "99"},
    {"\n4902 = 3", "\n902 = 3", "toml-syntax", "902"},
    {"\n4903 = 3", "\n4903 = 33", "value-range", "33"},
    {"width = 16", "width = 1", "declaration-invalid", "1"},
    {"signed = false", "signed = flase", "toml-syntax", "flase"},
    {"CanOpenBaudrate = 250", "CanOpenBaudrate = 2500", "value-range", "2500"},
};

diagnostic::Position position_in(const std::string& text, std::size_t offset) {
    diagnostic::Position position{1, 1};
    for (std::size_t i = 0; i < offset; ++i) {
        position = text[i] == '\n' ? diagnostic::Position{position.line + 1, 1}
                                   : diagnostic::Position{position.line, position.column + 1};
    }
    return position;
}

TEST(OneSlip, gives_one_finding_at_its_place) {
    const std::string genset = sample("genset.toml");
    for (const Slip& slip : slips) {
        SCOPED_TRACE(std::string(slip.mistaken));
        const std::size_t at = genset.find(slip.typed);
        ASSERT_NE(at, std::string::npos);
        std::string text = genset;
        text.replace(at, slip.typed.size(), slip.mistaken);
        parameter::Catalogue rows(catalogue::shipped_rows());
        const auto findings = test::check_text(text, "genset.toml", {}, rows).findings;
        ASSERT_EQ(findings.all().size(), 1U) << findings_text(findings);
        const diagnostic::Diagnostic& finding = findings.all()[0];
        EXPECT_EQ(finding.rule->name, slip.rule) << findings_text(findings);
        if (!slip.place.empty()) {
            const auto expected = position_in(text, at + slip.mistaken.rfind(slip.place));
            EXPECT_EQ(finding.where.range.start, expected) << findings_text(findings);
        }
    }
}

std::string minimal_findings_after(std::string_view typed, std::string_view mistaken) {
    std::string text = sample("minimal.toml");
    text.replace(text.find(typed), typed.size(), mistaken);
    parameter::Catalogue rows(catalogue::shipped_rows());
    std::string rules;
    const test::CheckedText checked = test::check_text(text, "minimal.toml", {}, rows);
    for (const diagnostic::Diagnostic& finding : checked.findings.all()) {
        rules += (rules.empty() ? "" : " ") + std::string(finding.rule->name);
    }
    return rules;
}

TEST(OneSlip, in_a_number_is_not_reported_as_missing_too) {
    EXPECT_EQ(minimal_findings_after("427 = 1", "47 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("4406 = 1", "4407 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("402 = 1", "\"402 CanDCNodeNumbr\" = 1"), "parameter-name-mismatch");
}

TEST(OneSlip, in_a_number_that_is_no_number_any_more_is_one_finding_too) {
    EXPECT_EQ(minimal_findings_after("403 = 1", "c03 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("403 = 1", "4O3 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("403 = 1", "4.3 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("4406 = 1", "44O6 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("4406 = 1", "4406b = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("4406 = 1", "440.6 = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("401 = 1", "40l = 1"), "parameter-unknown");
    EXPECT_EQ(minimal_findings_after("401 = 1     # CanMyNodeNumber\n", "2401 = 1\n"),
              "parameter-not-settable");
}

TEST(OneSlip, in_a_header_is_one_finding) {
    for (const char* header : {"[gateway6parameters]", "[gatewayparameters]", "[gateway_parameters]"}) {
        EXPECT_EQ(minimal_findings_after("[gateway.parameters]", header), "key-unknown") << header;
    }
    EXPECT_EQ(minimal_findings_after("[governor.parameters]", "[governor_parameters]"), "key-unknown");
}

TEST(OneSlip, that_takes_a_header_away_is_one_finding) {
    EXPECT_EQ(minimal_findings_after("[governor.parameters]", "#governor.parameters]"), "key-unknown");
    EXPECT_EQ(minimal_findings_after("[governor.parameters]", "[governor]"), "key-unknown");
    EXPECT_EQ(minimal_findings_after("[gateway.parameters]", "[gateway]"), "key-unknown");
}

TEST(OneSlip, in_the_format_is_one_finding) {
    EXPECT_EQ(minimal_findings_after("format = 1", "fomat = 1"), "key-unknown");
}

std::vector<bool> outside_comments(const std::string& text) {
    std::vector<bool> outside;
    bool in_comment = false;
    for (const char c : text) {
        in_comment = c != '\n' && (in_comment || c == '#');
        outside.push_back(!in_comment);
    }
    return outside;
}

void expect_one_finding_at_most(const std::string& text, const std::string& slip) {
    parameter::Catalogue rows(catalogue::shipped_rows());
    const auto findings = test::check_text(text, "minimal.toml", {}, rows).findings;
    EXPECT_LE(findings.all().size(), 1U) << slip << "\n" << findings_text(findings);
}

// No exceptions: TOML that is damaged (a lost bracket, quote or line end) is one finding as well.
TEST(OneSlip, anywhere_in_minimal_is_one_finding_at_most) {
    const std::string minimal = sample("minimal.toml");
    const std::vector<bool> outside = outside_comments(minimal);
    int slips_made = 0;
    for (std::size_t i = 0; i < minimal.size(); ++i) {
        if (!outside[i]) {
            continue;
        }
        const auto place = position_in(minimal, i);
        const std::string at = fmt::format("{}:{}", place.line, place.column);
        expect_one_finding_at_most(std::string(minimal).erase(i, 1), at + " deleted");
        expect_one_finding_at_most(std::string(minimal).replace(i, 1, "x"), at + " x");
        slips_made += 2;
    }
    EXPECT_GT(slips_made, 300);
}

}  // namespace
}  // namespace cgw::check
