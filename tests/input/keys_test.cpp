// Which parameter a key means.
#include "input/support.hpp"

namespace cgw {
namespace {

using test::gateway;
using test::gateway_findings;
using test::governor;
using test::governor_findings;
using test::head;
using test::Outcome;
using test::read;
using test::show;

TEST(InputKeys, a_parameter_has_four_spellings) {
    for (const char* line :
         {"400 = 2", "CanStartTimeOutDelay = 2", "\"400 CanStartTimeOutDelay\" = 2",
          "canstarttimeoutdelay = 2", "\"400\tCANSTARTTIMEOUTDELAY \" = 2", "\" 400\" = 2"}) {
        const Outcome outcome = read(head + gateway + governor + line + "\n");
        EXPECT_EQ(show(outcome.findings), "fine") << line;
        EXPECT_EQ(outcome.settings().governor.value(400), 2) << line;
    }
}

TEST(InputKeys, an_element_of_an_array_has_a_number_and_a_name) {
    for (const char* line : {"16407 = 0x382", "\"CanOpTPDO5-16ID(3)\" = 0x382",
                             "\"CanOpTPDO5-16ID (3)\" = 0x382", "\"16407 canoptpdo5-16id(3)\" = 0x382"}) {
        const Outcome outcome = read(head + governor + gateway + line + "\n");
        EXPECT_EQ(show(outcome.findings), "fine") << line;
        const parameter::Assignment* assignment = outcome.settings().gateway.find(16407);
        ASSERT_NE(assignment, nullptr) << line;
        EXPECT_EQ(assignment->value, 0x382);
        EXPECT_FALSE(assignment->decimal_typed);
    }
}

TEST(InputKeys, an_array_name_without_an_index_is_its_first_element) {
    const Outcome outcome = read(head + governor + gateway + "CanOpTPDO5-16ID = 0x282\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().gateway.value(16404), 0x282);
}

TEST(InputKeys, an_assignment_knows_its_places_and_spelling) {
    const Outcome outcome = read(head + governor + gateway + "\"429 CanOpHeartBeatTxTime\" = 1_000\n");
    const parameter::Assignment* assignment = outcome.settings().gateway.find(429);
    ASSERT_NE(assignment, nullptr);
    EXPECT_EQ(assignment->spelling, "429 CanOpHeartBeatTxTime");
    EXPECT_EQ(assignment->row->number, 429);
    EXPECT_EQ(assignment->value, 1000);
    EXPECT_TRUE(assignment->decimal_typed);
    EXPECT_EQ(assignment->key.path, "f.toml");
    EXPECT_EQ(assignment->key.range.start, (diagnostic::Position{13, 1}));
    EXPECT_EQ(assignment->where.range.start, (diagnostic::Position{13, 30}));
    EXPECT_EQ(assignment->where.range.end, (diagnostic::Position{13, 35}));
}

TEST(InputKeys, the_same_number_means_different_things_in_the_two_devices) {
    const Outcome outcome = read(head + governor + "16404 = 2000\n" + gateway + "16404 = 0x282\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.find(16404)->row->name, "CanOpTPDO5Assign(0)");
    EXPECT_EQ(outcome.settings().gateway.find(16404)->row->name, "CanOpTPDO5-16ID(0)");
}

TEST(InputKeys, aliases_are_accepted) {
    EXPECT_EQ(gateway_findings("HzmCanSegmentOrBaudrate = 0\n"), "fine");
    EXPECT_EQ(gateway_findings("\"4416 hzmcansegmentorbaudrate\" = 0\n"), "fine");
}

TEST(InputKeys, the_manuals_misprints_mean_what_they_should) {
    for (const char* line : {"409 = 500\n", "\"409 CanBaudrate\" = 500\n"}) {
        const Outcome outcome = read(head + gateway + "[governor.parameters]\n401 = 1\n403 = 1\n" + line);
        EXPECT_EQ(show(outcome.findings), "fine") << line;
        ASSERT_NE(outcome.settings().governor.find(416), nullptr) << line;
        EXPECT_EQ(outcome.settings().governor.value(416), 500) << line;
        EXPECT_EQ(outcome.settings().governor.find(416)->spelling.substr(0, 3), "409") << line;
    }
    EXPECT_EQ(governor_findings("4409 = 0\n"), "fine");
    const Outcome outcome = read(head + gateway + governor + "\"4901 ChanType_Setp1Ext\" = 3\n");
    EXPECT_EQ(show(outcome.findings), "fine");
    EXPECT_EQ(outcome.settings().governor.value(4901), 3);
    EXPECT_EQ(outcome.settings().governor.find(4900), nullptr);
}

TEST(InputKeys, misprints_of_the_governor_are_none_of_the_gateway) {
    EXPECT_EQ(gateway_findings("409 = 250\n"),
              "E0105 13:1 the gateway has no parameter `409` | 416 CanBaudrate belongs to the governor: "
              "write it in [governor.parameters]");
}

TEST(InputKeys, a_name_without_a_number_is_the_parameter_that_has_it) {
    const Outcome outcome = read(head + gateway + governor + "ChanType_Setp1Ext = 3\n");
    EXPECT_EQ(outcome.settings().governor.value(4900), 3);
}

TEST(InputKeys, a_row_without_a_name_takes_any_name_that_is_nobody_elses) {
    EXPECT_EQ(governor_findings("812 = 3\n"), "fine");
    EXPECT_EQ(governor_findings("\"812 FunctMaxSpeed\" = 3\n"), "fine");
    EXPECT_EQ(governor_findings("\"812 CanCommCMOn\" = 3\n"),
              "E0106 13:1 812 is another parameter, but CanCommCMOn is 4406 | write \"812\" or \"4406 "
              "CanCommCMOn\"");
}

TEST(InputKeys, number_and_name_must_belong_together) {
    EXPECT_EQ(governor_findings("\"400 CanCommCMOn\" = 1\n"),
              "E0106 13:1 400 is CanStartTimeOutDelay, but CanCommCMOn is 4406 | "
              "write \"400 CanStartTimeOutDelay\" or \"4406 CanCommCMOn\"");
    EXPECT_EQ(governor_findings("\"400 CanStartDelay\" = 1\n"),
              "E0106 13:1 400 is CanStartTimeOutDelay, but no parameter is named `CanStartDelay` | "
              "write \"400 CanStartTimeOutDelay\"");
    EXPECT_EQ(
        governor_findings("\"499 CanCommCMOn\" = 1\n"),
        "E0106 13:1 the governor has no parameter 499, but CanCommCMOn is 4406 | write \"4406 CanCommCMOn\"");
    EXPECT_EQ(governor_findings("\"16405 CanOpTPDO5Assign\" = 1\n"),
              "E0106 13:1 16405 is CanOpTPDO5Assign(1), but CanOpTPDO5Assign(0) is 16404 | "
              "write \"16405 CanOpTPDO5Assign(1)\" or \"16404 CanOpTPDO5Assign(0)\"");
}

TEST(InputKeys, a_mismatch_is_not_reported_as_missing_too) {
    EXPECT_EQ(
        show(read(head + gateway + "[governor.parameters]\n401 = 1\n\"403 CanBaudrate\" = 250\n").findings),
        "E0106 11:1 403 is CanCMNodeNumber, but CanBaudrate is 416 | "
        "write \"403 CanCMNodeNumber\" or \"416 CanBaudrate\"");
}

TEST(InputKeys, an_unknown_parameter_gets_a_suggestion) {
    EXPECT_EQ(governor_findings("CanComCMOn = 1\n"),
              "E0105 13:1 the governor has no parameter `CanComCMOn` | did you mean `CanCommCMOn`?");
    EXPECT_EQ(governor_findings("\"CanOpTPDO4-16Cyc(3)\" = 1\n").substr(0, 66),
              "E0105 13:1 the governor has no parameter `CanOpTPDO4-16Cyc(3)` | d");
    EXPECT_EQ(governor_findings("999 = 1\n"),
              "E0105 13:1 the governor has no parameter `999` | "
              "what the shipped catalogue does not know can be added by a file: catalogue = [\"...\"]");
}

TEST(InputKeys, a_parameter_of_the_other_device_is_said_to_be_its) {
    EXPECT_EQ(governor_findings("427 = 1\n"),
              "E0105 13:1 the governor has no parameter `427` | 427 CanOpenMyNodeID belongs to the gateway: "
              "write it in [gateway.parameters]");
    EXPECT_EQ(
        gateway_findings("CanBaudrate = 250\n"),
        "E0105 13:1 the gateway has no parameter `CanBaudrate` | 416 CanBaudrate belongs to the governor: "
        "write it in [governor.parameters]");
    EXPECT_EQ(gateway_findings("\"4406 CanCommCMOn\" = 1\n"),
              "E0105 13:1 the gateway has no parameter `4406 CanCommCMOn` | 4406 CanCommCMOn belongs to the "
              "governor: "
              "write it in [governor.parameters]");
    EXPECT_EQ(
        gateway_findings("Speed = 1\n"),
        "E0105 13:1 the gateway has no parameter `Speed` | 2000 Speed is a measurement of the governor");
}

TEST(InputKeys, odd_keys_are_unknown) {
    for (const char* key : {"\"\"", "\" \"", "0401", "65536", "99999999999999999999", "\"401x\"", "-401",
                            "\"(0)\"", "\"401 \\u001b\"", "0x191"}) {
        const std::string findings = governor_findings(std::string(key) + " = 1\n");
        EXPECT_TRUE(findings.starts_with("E0105 13:1 the governor has no parameter `") ||
                    findings.starts_with("E0106 13:1 "))
            << findings;
        EXPECT_EQ(findings.find('\x1b'), std::string::npos);
    }
}

TEST(InputKeys, a_measurement_cannot_be_set) {
    EXPECT_EQ(governor_findings("2000 = 1500\n"), "E0107 13:1 2000 Speed is a measurement and cannot be set");
    EXPECT_EQ(gateway_findings("\"2401 CanTxBufferState\" = 1\n"),
              "E0107 13:1 2401 CanTxBufferState is a measurement and cannot be set");
}

TEST(InputKeys, a_parameter_is_set_once_by_whatever_spelling) {
    EXPECT_EQ(governor_findings("CanMyNodeNumber = 1\n"),
              "E0108 13:1 401 CanMyNodeNumber is set twice [first set here 10:1]");
    EXPECT_EQ(governor_findings("409 = 250\n\"416 CanBaudrate\" = 250\n"),
              "E0108 13:1 416 CanBaudrate is set twice [first set here 12:1]\n"
              "E0108 14:1 416 CanBaudrate is set twice [first set here 12:1]");
    EXPECT_EQ(governor_findings("16400 = [2000, 2000]\n\"CanOpTPDO4Assign(1)\" = 0\n"),
              "E0108 14:1 16401 CanOpTPDO4Assign(1) is set twice [first set here 13:16]");
    EXPECT_EQ(governor_findings("16401 = 1\nCanOpTPDO4Assign = [2, 3]\n"),
              "E0108 14:24 16401 CanOpTPDO4Assign(1) is set twice [first set here 13:1]");
}

TEST(InputKeys, the_first_of_two_values_holds) {
    const Outcome outcome = read(head + gateway + governor + "4406 = 1\nCanCommCMOn = 0\n");
    EXPECT_EQ(outcome.settings().governor.value(4406), 1);
}

// In place of "403 = 1" in [governor.parameters], with the table's other keys around it.
std::string instead_of_403(const std::string& line) {
    return show(read(head + gateway + "[governor.parameters]\n401 = 1\n" + line + "\n416 = 250\n").findings);
}

TEST(InputKeys, a_number_with_a_slip_in_it_is_one_finding) {
    for (const char* key : {"c03", "4O3", "4o3", "40E", "4033", "43", "043", "\"40 3\""}) {
        const std::string shown = key[0] == '"' ? "40 3" : key;
        EXPECT_EQ(
            instead_of_403(std::string(key) + " = 1"),
            "E0105 11:1 the governor has no parameter `" + shown + "` | did you mean 403 CanCMNodeNumber?");
    }
    EXPECT_EQ(instead_of_403("4.3 = 1"),
              "E0105 11:1 the governor has no parameter `4` | did you mean 403 CanCMNodeNumber?");
    EXPECT_EQ(governor_findings("44O6 = 1\n"),
              "E0105 13:1 the governor has no parameter `44O6` | did you mean 4406 CanCommCMOn?");
}

TEST(InputKeys, a_number_that_became_another_one_is_one_finding) {
    EXPECT_EQ(show(read(head + gateway + "[governor.parameters]\nCanMyNodeNumber = 1\n401 = 1\n416 = 250\n")
                       .findings),
              "E0108 11:1 401 CanMyNodeNumber is set twice [first set here 10:1]");
    EXPECT_EQ(show(read(head + governor +
                        "[gateway.parameters]\n2401 = 1\n402 = 1\n416 = 250\n426 = 125\n"
                        "427 = 1\n")
                       .findings),
              "E0107 8:1 2401 CanTxBufferState is a measurement and cannot be set");
}

TEST(InputKeys, a_number_far_from_all_others_leaves_the_missing_one_missing) {
    EXPECT_EQ(instead_of_403("4xx3x = 1").find("E0109"), 0U);
    EXPECT_EQ(instead_of_403("999 = 1").find("E0109"), 0U);
}

TEST(InputKeys, what_was_meant_is_not_missing_after_any_number_of_unknown_keys) {
    std::string lines;
    for (int i = 0; i < 60; ++i) {
        lines += fmt::format("Nonsense{}ForAllToSee = 1\n", i);
    }
    for (const char* key : {"4O3", "43", "CanCMNodNumber"}) {
        const Outcome outcome =
            read(head + gateway + "[governor.parameters]\n401 = 1\n416 = 250\n" + lines + key + " = 1\n");
        EXPECT_EQ(outcome.findings.all().size(), 61U) << key;
    }
}

TEST(InputKeys, a_file_of_nonsense_stays_quick) {
    std::string lines;
    for (int i = 0; i < 2000; ++i) {
        lines += fmt::format("CanOpTPDOxAssignment{} = {}\n", i, i);
    }
    const Outcome outcome = read(head + gateway + governor + lines);
    EXPECT_EQ(outcome.findings.all().size(), 2000U);
    EXPECT_TRUE(outcome.findings.all().back().help.empty());
}

}  // namespace
}  // namespace cgw
