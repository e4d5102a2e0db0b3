// Warnings (D35): when they speak, what they propose, and when something else covers them.
#include <gtest/gtest.h>

#include "check/findings_text.hpp"
#include "check/overlay.hpp"

namespace cgw::check {
namespace {

std::string findings_of(std::string_view fragment) {
    return test::findings_text(test::findings_with(fragment));
}

// "E0301 E0402": the codes alone.
std::string codes_of(std::string_view fragment) {
    const diagnostic::Findings findings = test::findings_with(fragment);
    std::string text;
    for (const diagnostic::Diagnostic& finding : findings.all()) {
        text += (text.empty() ? "" : " ") + std::string(finding.rule->code);
    }
    return text;
}

// RPDO1 with one switch function, watched for `time`.
std::string rpdo1_with(std::string_view time, std::string_view more = {}) {
    return fmt::format("[governor.parameters]\n835 = 1\n4835 = 3\n16480 = {}\n{}", time, more);
}

std::string heartbeat_with(std::string_view time) {
    return fmt::format("[gateway.parameters]\n428 = 2\n430 = {}\n", time);
}

}  // namespace

TEST(EarlyMonitoring, names_the_time_that_is_watched_and_the_next_that_works) {
    EXPECT_EQ(
        findings_of(rpdo1_with("100")),
        "11:9 E0301 monitoring-early: 16480 CanOpRPDO1-4Cyc(0) is 100 ms, but RPDO1 is missed after 93.75 "
        "ms already: a sender that keeps to 100 ms trips it (manual 7.1.5)\n"
        "  help: 110 ms is the next time that works: 7 main cycles, 109.375 ms\n");
    EXPECT_EQ(codes_of(rpdo1_with("110")), "E0402");  // what was proposed is a note
    EXPECT_EQ(codes_of(rpdo1_with("125")), "");
}

TEST(EarlyMonitoring, of_the_heartbeat_counts_the_gateways_cycles) {
    EXPECT_EQ(
        findings_of(heartbeat_with("100")),
        "19:7 E0301 monitoring-early: 430 CanOpHeartBeatRxTime is 100 ms, but the heartbeat of node 2 is "
        "missed after 96 ms already: a sender that keeps to 100 ms trips it (manual 7.2.3)\n"
        "  help: 112 ms is the next time that works: 7 main cycles\n");
    EXPECT_EQ(codes_of(heartbeat_with("112")), "");
}

TEST(EarlyMonitoring, proposes_nothing_beyond_the_longest_time) {
    EXPECT_NE(
        findings_of(rpdo1_with("3999"))
            .find(
                "  help: no longer time is possible: let the sender send more often than every 3984.375 ms"),
        std::string::npos);
    EXPECT_NE(findings_of(heartbeat_with("65535")).find("more often than every 65520 ms"), std::string::npos);
    EXPECT_EQ(codes_of(rpdo1_with("4000")), "E0209");
    EXPECT_EQ(codes_of(rpdo1_with("4001")), "E0209");
}

TEST(EarlyMonitoring, is_content_with_every_time_it_proposes) {
    for (int time = 32; time < 400; time += 7) {
        const std::string text = findings_of(rpdo1_with(fmt::format("{}", time)));
        if (const std::size_t help = text.find("help: "); help != std::string::npos) {
            const std::string proposed = text.substr(help + 6, text.find(' ', help + 6) - help - 6);
            EXPECT_EQ(findings_of(rpdo1_with(proposed)).find("E0301"), std::string::npos) << text;
        }
    }
}

TEST(EarlyMonitoring, counts_in_the_governors_own_main_cycle) {
    EXPECT_EQ(codes_of("[governor]\nmain_cycle_us = 10000\n" + rpdo1_with("100")), "");
    EXPECT_NE(
        findings_of("[governor]\nmain_cycle_us = 30000\n" + rpdo1_with("100")).find("120 ms is the next"),
        std::string::npos);
}

TEST(ShortMonitoring, is_one_finding_whatever_else_is_wrong_with_the_time) {
    for (const char* time : {"1", "15", "16", "31"}) {
        EXPECT_EQ(codes_of(rpdo1_with(time)), "E0302") << time;
    }
    EXPECT_EQ(codes_of(rpdo1_with("32")), "E0402");
    EXPECT_NE(findings_of(rpdo1_with("20")).find("the shortest time of two main cycles is 32 ms"),
              std::string::npos);
    EXPECT_EQ(codes_of(heartbeat_with("31")), "E0302");
    EXPECT_EQ(codes_of(heartbeat_with("32")), "");
}

TEST(UnmonitoredRpdos, are_reported_where_the_zero_stands_or_where_they_become_active) {
    EXPECT_EQ(findings_of(rpdo1_with("0")),
              "11:9 E0303 rpdo-unmonitored: RPDO1 is not monitored, 16480 CanOpRPDO1-4Cyc(0) is 0: when its "
              "sender fails, the governor goes on with the last values (manual 7.1.5)\n"
              "  help: write 16480 = a time of several cycles of the sender, in ms\n");
    const std::string absent = findings_of("[governor.parameters]\n835 = 1\n4835 = 3\n");
    EXPECT_EQ(absent.find(
                  "9:7 E0303 rpdo-unmonitored: RPDO1 is not monitored, 16480 CanOpRPDO1-4Cyc(0) is not set"),
              0U)
        << absent;
}

TEST(UnmonitoredRpdos, are_each_a_finding_as_each_has_its_own_sender) {
    const std::string text = findings_of("[governor.parameters]\n906 = 6\n4906 = 3\n");
    EXPECT_NE(text.find("9:7 E0303 rpdo-unmonitored: RPDO1"), std::string::npos) << text;
    EXPECT_NE(text.find("9:7 E0303 rpdo-unmonitored: RPDO3"), std::string::npos) << text;
    EXPECT_EQ(codes_of("[governor.parameters]\n906 = 6\n4906 = 3\n16480 = [500, 0, 500]\n"), "");
}

TEST(UnmonitoredRpdos, are_not_reported_when_the_time_is_refused) {
    EXPECT_EQ(codes_of(rpdo1_with("70000")), "E0111");
    EXPECT_EQ(codes_of("[governor.parameters]\n835 = 1\n4835 = 3\n\"CanOpRPDO1-4Cy\" = 500\n"), "E0105");
}

TEST(InactiveRpdos, are_not_worth_monitoring) {
    EXPECT_EQ(
        findings_of("[governor.parameters]\n16480 = 500\n"),
        "9:9 E0304 rpdo-inactive-monitored: 16480 CanOpRPDO1-4Cyc(0) is 500 ms, but RPDO1 is not active: no "
        "switch function and no sensor comes over CANopen (manual 7.1.5)\n"
        "  help: write 16480 = 0, or assign what the RPDO carries\n");
    EXPECT_NE(findings_of("[governor.parameters]\n16483 = 500\n")
                  .find("no sensor uses one of its channels 9 to 12"),
              std::string::npos);
}

TEST(InactiveRpdos, are_not_reported_when_the_sensor_is_what_is_wrong) {
    const auto with_sensor = [](std::string_view channel) {
        return fmt::format("[governor.parameters]\n906 = {}\n4906 = 3\n16480 = [500, 500]\n", channel);
    };
    EXPECT_EQ(codes_of(with_sensor("1")), "");
    EXPECT_EQ(codes_of(with_sensor("13")), "E0211");
    EXPECT_EQ(codes_of(with_sensor("0")), "E0310");
    EXPECT_EQ(codes_of(with_sensor("1.5")), "E0110");
}

TEST(DecimalLiterals, are_reported_where_both_readings_differ) {
    EXPECT_EQ(codes_of("[gateway.parameters]\n16404 = 9\n"), "");
    EXPECT_EQ(codes_of("[gateway.parameters]\n16404 = 10\n"), "E0305");
    EXPECT_EQ(codes_of("[gateway.parameters]\n16404 = 0o1202\n"), "");
    EXPECT_EQ(codes_of("[gateway.parameters]\n427 = 10\n"), "");
    EXPECT_NE(findings_of("[gateway.parameters]\n16404 = 1664\n").find("  help: write 0x680\n"),
              std::string::npos);
}

TEST(DecimalLiterals, cover_every_advice_about_the_identifier_but_no_error) {
    const auto with_identifier = [](std::string_view identifier, std::string_view more = {}) {
        return fmt::format(
            "[governor.parameters]\n16404 = 2000\n16461 = 125\n[gateway.parameters]\n16404 = {}\n{}",
            identifier, more);
    };
    EXPECT_EQ(codes_of(with_identifier("282")), "E0305");  // 11Ah is restricted
    EXPECT_EQ(codes_of(with_identifier("642")), "E0305");  // 282h, node 2's TPDO2
    EXPECT_EQ(codes_of(with_identifier("514")), "E0305");  // 202h, node 2's RPDO1
    EXPECT_EQ(codes_of(with_identifier("128")), "E0205");  // 080h
    EXPECT_EQ(codes_of(with_identifier("642", "[network]\nnodes = [2]\n")), "E0207");
}

TEST(RestrictedIdentifiers, are_the_ranges_of_d33) {
    for (const char* identifier : {"0x1", "0x7F", "0x101", "0x180", "0x582", "0x5FF", "0x602", "0x67F",
                                   "0x6E0", "0x6FF", "0x702", "0x77F", "0x780", "0x7FF"}) {
        EXPECT_EQ(
            codes_of(fmt::format("[governor.parameters]\n16404 = 2000\n16461 = 125\n[gateway.parameters]\n"
                                 "16404 = {}\n",
                                 identifier)),
            "E0306")
            << identifier;
    }
}

TEST(RestrictedIdentifiers, do_not_matter_to_an_inactive_tpdo) {
    EXPECT_EQ(codes_of("[gateway.parameters]\n16404 = [0x3, 0x282, 0x202]\n"), "");
}

TEST(EmptyTpdos, are_one_finding_each_unless_a_word_is_refused) {
    EXPECT_EQ(codes_of("[governor.parameters]\n16460 = [125, 0, 125]\n"), "E0307 E0307");
    EXPECT_EQ(codes_of("[governor.parameters]\n16400 = 2301\n16460 = 125\n"), "E0213");
    EXPECT_EQ(codes_of("[governor.parameters]\nCanOpTPDO4Assig = 2000\n16460 = 125\n"), "E0105");
    EXPECT_EQ(codes_of("[governor.parameters]\n16400 = 40000\n16460 = 125\n"), "E0111");
}

TEST(UnsentTpdos, are_reported_at_their_first_word) {
    EXPECT_EQ(
        findings_of("[governor.parameters]\n16400 = [0, 2031, 2300]\n"),
        "9:13 E0308 tpdo-unsent: 16401 CanOpTPDO4Assign(1) is 2031 SpeedSetp, but TPDO4 is never sent: 16460 "
        "CanOpTPDO4-16Cyc(0) is not set (manual 7.1.3)\n"
        "  help: write its cycle time in ms as 16460\n");
    EXPECT_EQ(codes_of("[governor.parameters]\n16400 = 2000\n16460 = 70000\n"), "E0111");
    EXPECT_EQ(codes_of("[governor.parameters]\n16400 = 2301\n"), "E0213");
}

TEST(SwitchesAndSensors, that_are_given_to_canopen_have_a_place) {
    EXPECT_EQ(
        findings_of("[governor.parameters]\n4835 = 3\n"),
        "9:8 E0309 switch-without-bit: 4835 Type_LoadEnable is 3 (CANopen), but 835 FunctLoadEnable is not "
        "set: no bit of RPDO1 switches it (manual 7.1.4.1)\n"
        "  help: write 835 = its bit of RPDO1 word 1, 1 to 16, negative when low-active\n");
    EXPECT_EQ(codes_of("[governor.parameters]\n4900 = 3\n"), "E0310");
    EXPECT_EQ(codes_of("[governor.parameters]\n4835 = 1\n4900 = 2\n"), "");
    EXPECT_EQ(codes_of("[governor.parameters]\n835 = 1.5\n4835 = 3\n"), "E0110");
    EXPECT_EQ(codes_of("[governor.parameters]\n4810 = 3\n"), "E0212");
}

TEST(SwitchesAndSensors, on_one_place_are_reported_at_the_later_number) {
    const std::string text = findings_of(rpdo1_with("500", "811 = -1\n4811 = 3\n827 = 1\n4827 = 3\n"));
    EXPECT_EQ(
        text,
        "9:7 E0311 switch-bit-shared: 835 FunctLoadEnable uses bit 1 of RPDO1 word 1, as 811 FunctIdleSpeed "
        "does already (manual 7.1.4.1)\n"
        "  see 12:7: the governor's 811 FunctIdleSpeed is -1 here\n"
        "14:7 E0311 switch-bit-shared: 827 FunctSetpoint2Or1 uses bit 1 of RPDO1 word 1, as 811 "
        "FunctIdleSpeed "
        "does already (manual 7.1.4.1)\n"
        "  see 12:7: the governor's 811 FunctIdleSpeed is -1 here\n");
}

TEST(StartUpDelays, are_compared_with_0_for_the_one_that_is_not_set) {
    EXPECT_EQ(
        findings_of("[gateway.parameters]\n400 = 1.5\n"),
        "18:7 E0313 start-up-delay-mismatch: the governor's 400 CanStartTimeOutDelay is not set, but the "
        "gateway's 400 CanStartTimeOutDelay is 1.5 s: one device expects the other before it is up (manual "
        "7.1.1)\n"
        "  help: write 400 = 1.5 in both tables\n");
    EXPECT_EQ(codes_of("[gateway.parameters]\n400 = 0\n"), "");
    EXPECT_EQ(codes_of("[governor.parameters]\n400 = 1\n[gateway.parameters]\n400 = 101\n"), "E0111");
    EXPECT_EQ(codes_of("[governor.parameters]\n400 = 1\n4406 = 0\n"), "E0215");
}

TEST(Partners, are_named_to_be_monitored) {
    EXPECT_EQ(codes_of("[gateway.parameters]\n428 = 2\n"), "E0314");
    EXPECT_EQ(codes_of("[gateway.parameters]\n428 = 1\n"), "E0203");
    EXPECT_EQ(codes_of("[gateway.parameters]\n428 = 2\n430 = -1\n"), "E0111");
}

TEST(Heartbeats, are_missed_at_the_header_when_nothing_is_typed) {
    const std::string text = findings_of("[gateway.parameters]\n# 429 = 800\n");
    EXPECT_EQ(text.find("10:1 E0315 heartbeat-off: 429 CanOpHeartBeatTxTime is not set: "), 0U) << text;
    EXPECT_EQ(codes_of("[gateway.parameters]\n429 = 70000\n"), "E0111");
}

}  // namespace cgw::check
