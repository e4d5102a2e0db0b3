// Notes (D35): what the devices make of a setting.
#include <gtest/gtest.h>

#include "check/findings_text.hpp"
#include "check/overlay.hpp"

namespace cgw::check {
namespace {

std::string findings_of(std::string_view fragment) {
    return test::findings_text(test::findings_with(fragment));
}

std::string with_tpdo5(std::string_view identifier, std::string_view more = {}) {
    return fmt::format(
        "[governor.parameters]\n16404 = 2000\n16461 = 125\n[gateway.parameters]\n16404 = {}\n{}", identifier,
        more);
}

}  // namespace

TEST(Misprints, are_named_in_every_accepted_form) {
    const std::string expected =
        "9:1 E0401 manual-misprint: `{}` is a misprint of the manual, read as 416 CanBaudrate\n"
        "  help: write \"416 CanBaudrate\"\n";
    for (const char* key : {"409", "409 CanBaudrate", "409  canbaudrate "}) {
        const std::string text =
            findings_of(fmt::format("[governor.parameters]\n# 416 = 250\n\"{}\" = 250\n", key));
        EXPECT_EQ(text, fmt::format(fmt::runtime(expected), key));
    }
    EXPECT_EQ(findings_of("[governor.parameters]\n\"4901 ChanType_Setp1Ext\" = 0\n"),
              "9:1 E0401 manual-misprint: `4901 ChanType_Setp1Ext` is a misprint of the manual, read as 4901 "
              "ChanType_Setp2Ext\n"
              "  help: write \"4901 ChanType_Setp2Ext\"\n");
}

TEST(Misprints, are_no_note_for_d3s_variants) {
    EXPECT_EQ(
        findings_of(
            "[governor.parameters]\n4901 = 0\n\"16471 CanOpTPDO4-16Cyc (11)\" = 0\n"
            "\"4416 cansegmentorbaudrate\" = 0\n[gateway.parameters]\n\"4416 HzmCanSegmOrBaudrate\" = 0\n"),
        "");
}

TEST(QuantisedTimes, are_those_that_become_others) {
    const auto with_cycle = [](std::string_view time) {
        return findings_of(fmt::format("[governor.parameters]\n16400 = 2000\n16460 = {}\n", time));
    };
    EXPECT_EQ(with_cycle("125"), "");
    EXPECT_EQ(with_cycle("3999"),
              "10:9 E0402 time-quantised: 16460 CanOpTPDO4-16Cyc(0) is 3999 ms, in effect 3984.375 ms: 255 "
              "main cycles "
              "of the governor (manual 7.1.3)\n");
    EXPECT_EQ(with_cycle("1"),
              "10:9 E0402 time-quantised: 16460 CanOpTPDO4-16Cyc(0) is 1 ms, in effect 15.625 ms: 1 main "
              "cycle of the "
              "governor (manual 7.1.3)\n");
    EXPECT_EQ(with_cycle("4001").find("E0402"), std::string::npos);
}

TEST(MovedWords, are_one_note_per_tpdo) {
    EXPECT_EQ(findings_of("[governor.parameters]\n16400 = [0, 2000, 2031, 0]\n16460 = 125\n"),
              "9:13 E0403 tpdo-words-moved: TPDO4 closes up over a 0: word 2 (2000 Speed) is sent as word 1, "
              "word 3 (2031 "
              "SpeedSetp) is sent as word 2 (manual 7.1.2.2)\n"
              "  see 9:10: the governor's 16400 CanOpTPDO4Assign(0) is 0 here\n");
    EXPECT_EQ(findings_of("[governor.parameters]\n16400 = [2000, 2031, 0, 0]\n16460 = 125\n"), "");
}

TEST(MovedWords, are_not_noted_when_the_gap_is_an_error) {
    const diagnostic::Findings findings =
        test::findings_with("[governor.parameters]\n16400 = [2301, 2000]\n16460 = 125\n");
    ASSERT_EQ(findings.all().size(), 1U) << test::findings_text(findings);
    EXPECT_TRUE(findings.has_errors());
}

TEST(UnlistedOwners, are_noted_and_listed_ones_are_an_error) {
    for (const char* identifier : {"0x82", "0x182", "0x282", "0x382", "0x482"}) {
        const std::string text = findings_of(with_tpdo5(identifier));
        EXPECT_NE(text.find("E0404"), std::string::npos) << text;
        EXPECT_NE(text.find("which belongs to node 2 for its "), std::string::npos) << text;
        const std::string listed = findings_of(with_tpdo5(identifier, "[network]\nnodes = [2]\n"));
        EXPECT_NE(listed.find("E0207"), std::string::npos) << listed;
        EXPECT_EQ(listed.find("E0404"), std::string::npos) << listed;
    }
}

TEST(UnlistedOwners, include_the_partner_and_exclude_the_gateway) {
    const std::string partner = "428 = 2\n430 = 2000\n";
    EXPECT_NE(findings_of(with_tpdo5("0x282", partner)).find("E0404"), std::string::npos);
    EXPECT_EQ(findings_of(with_tpdo5("0x81")), "");
    EXPECT_EQ(findings_of(with_tpdo5("0x281")), "");
}

TEST(DefaultRpdos, are_noted_whether_the_node_is_listed_or_not) {
    for (const auto& [identifier, rpdo] : {std::pair{"0x202", 1}, {"0x302", 2}, {"0x402", 3}, {"0x502", 4}}) {
        const std::string expected = fmt::format("received by node 2's default RPDO{}\n", rpdo);
        EXPECT_NE(findings_of(with_tpdo5(identifier)).find(expected), std::string::npos) << identifier;
        EXPECT_NE(findings_of(with_tpdo5(identifier, "[network]\nnodes = [2]\n")).find(expected),
                  std::string::npos);
    }
    EXPECT_EQ(findings_of(with_tpdo5("0x201")), "");  // the gateway's own
}

TEST(ManualTiming, makes_the_bit_rates_incomparable) {
    EXPECT_EQ(findings_of("[governor.parameters]\n4416 = 1\n416 = 500\n[gateway.parameters]\n4416 = 1\n"),
              "9:8 E0406 hzm-bit-rate-unverified: the governor's 4416 CanSegmentOrBaudrate is 1, bit timing "
              "by hand: "
              "whether both devices have the same bit rate cannot be verified (manual 7.1.1)\n"
              "  see 19:8: the gateway's 4416 HzmCanSegmOrBaudrate is 1 here\n");
    EXPECT_NE(findings_of("[gateway.parameters]\n4416 = 1\n").find("the gateway's 4416"), std::string::npos);
    EXPECT_EQ(findings_of("[gateway.parameters]\n4426 = 1\n"), "");
}

// The registers of 16 MHz, MCP2515: (BRP) 1 is 250 kbit/s, 0 is 500 kbit/s.
TEST(ManualTiming, of_the_gateway_is_compared_when_its_clock_is_stated) {
    const auto with_prescaler = [](int prescaler) {
        return findings_of(fmt::format(
            "[gateway]\nbit_timing = {{ can1 = {{ clock_hz = 16000000, family = \"mcp2515\" }} }}\n"
            "[gateway.parameters]\n4416 = 1\n410 = {}\n413 = 6\n414 = 1\n415 = 5\n",
            prescaler));
    };
    EXPECT_EQ(with_prescaler(1), "");
    EXPECT_EQ(with_prescaler(0),
              "7:7 E0202 hzm-bit-rate-mismatch: the governor's 416 CanBaudrate is 250 kbit/s, but the "
              "gateway's bit "
              "timing by hand is 500 kbit/s; both share the HEINZMANN CAN bus (manual 7.1.1)\n"
              "  see 19:8: the gateway's 4416 HzmCanSegmOrBaudrate is 1 here\n");
    EXPECT_EQ(with_prescaler(400).find("E0202"), std::string::npos);
}

}  // namespace cgw::check
