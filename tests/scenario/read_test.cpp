// Every mistake in a scenario file is a finding with its place.
#include "scenario/actions.hpp"
#include "scenario/stage.hpp"

namespace cgw::scenario {
namespace {

std::string findings_in(const std::string& text) {
    diagnostic::Findings findings;
    read_scenario(text, "test.toml", findings);
    return test::findings_text(findings);
}

std::string findings_in_step(const std::string& step) {
    return findings_in(test::scenario_text("  { " + step + " },"));
}

TEST(ScenarioFile, is_read_with_its_times_in_microseconds) {
    diagnostic::Findings findings;
    const Scenario scenario = read_scenario(
        "format = 1\ntitle = \"A title\"\nplant = \"../p.toml\"\ngovernor = \"g.toml\"\nduration = 2.5\n"
        "[[step]]\nat = 0.000001\nsilence = \"rpdo3\"\n"
        "[[step]]\nat = 2\nsaturate = \"CAN1\"\nid = 0x1F\nfor = 0.25\n",
        "test.toml", findings);
    EXPECT_EQ(test::findings_text(findings), "");
    EXPECT_EQ(scenario.title, "A title");
    EXPECT_EQ(scenario.plant, "../p.toml");
    EXPECT_EQ(scenario.governor, "g.toml");
    EXPECT_EQ(scenario.duration, 2'500'000U);
    ASSERT_EQ(scenario.steps.size(), 2U);
    EXPECT_EQ(scenario.steps[0].at, 1U);
    EXPECT_EQ(scenario.steps[0].action, find_action("silence"));
    EXPECT_EQ(scenario.steps[0].subject().integer, 2);
    EXPECT_EQ(scenario.steps[1].values[1].integer, 0x1F);
    EXPECT_EQ(scenario.steps[1].values[2].integer, 250'000);
}

TEST(ScenarioFile, says_its_format) {
    EXPECT_EQ(findings_in("duration = 1\n"),
              "0:0: format-missing: the file does not say its format (begin it with format = 1)\n"
              "0:0: key-missing: `format` is missing at the top of a scenario\n");
    EXPECT_EQ(findings_in("format = 2\nwhatever = 1\n"),
              "1:10: format-unsupported: the scenario is written in format 2, and this cgw reads format 1\n");
    EXPECT_EQ(findings_in("format = \"1\"\nduration = 1\n"),
              "1:10: key-type: `format` must be an integer, not a string\n");
}

TEST(ScenarioFile, that_is_no_toml_has_a_finding) {
    EXPECT_EQ(findings_in("format = \n").substr(0, 2), "1:");
    EXPECT_NE(findings_in("format = \n").find("toml-syntax"), std::string::npos);
}

TEST(ScenarioFile, needs_a_duration_within_limits) {
    EXPECT_EQ(findings_in("format = 1\n"),
              "0:0: key-missing: `duration` is missing at the top of a scenario\n");
    EXPECT_EQ(findings_in("format = 1\nduration = 0\n"),
              "2:12: key-value: `duration` is 0, outside 0.001..2592000\n");
    EXPECT_EQ(findings_in("format = 1\nduration = inf\n"),
              "2:12: key-value: `duration` is inf, outside 0.001..2592000\n");
}

TEST(ScenarioFile, proposes_the_key_that_was_meant) {
    EXPECT_EQ(findings_in("format = 1\ndurration = 1\n"),
              "2:1: key-unknown: unknown key `durration` at the top of a scenario "
              "(did you mean `duration`?)\n");
    EXPECT_EQ(findings_in("format = 1\nduration = 1\nplant = \"\"\n"),
              "3:9: key-value: `plant` is empty, too long, or contains a control character\n");
    EXPECT_EQ(findings_in("format = 1\nduration = 1\nstep = 3\n"),
              "3:8: key-type: `step` must be a list of steps, not an integer\n");
    EXPECT_EQ(findings_in("format = 1\nduration = 1\nstep = [3]\n"),
              "3:9: key-type: a step must be a table, not an integer\n");
}

TEST(ScenarioStep, has_a_time) {
    EXPECT_EQ(findings_in_step("reset = \"gateway\""), "4:3: key-missing: `at` is missing in a step\n");
    EXPECT_EQ(findings_in_step("at = \"1\", reset = \"gateway\""),
              "4:10: key-type: `at` must be a number of seconds, not a string\n");
    EXPECT_EQ(findings_in_step("at = -1, reset = \"gateway\""),
              "4:10: key-value: `at` is -1, outside 0..2592000\n");
}

TEST(ScenarioStep, has_one_action) {
    EXPECT_EQ(findings_in_step("at = 1"), "4:3: step-action: this step has no action\n");
    EXPECT_EQ(findings_in_step("at = 1, silense = \"RPDO1\""),
              "4:13: key-unknown: unknown key `silense` in a step (did you mean `silence`?)\n");
    EXPECT_EQ(findings_in_step("at = 1, reset = \"gateway\", drop = \"CAN1\""),
              "4:32: step-action: this step has two actions, `reset` and `drop` "
              "(give each action a step of its own)\n");
}

TEST(ScenarioStep, has_the_keys_of_its_action) {
    EXPECT_EQ(findings_in_step("at = 1, saturate = \"CAN1\", id = 1, fro = 2"),
              "4:40: key-unknown: unknown key `fro` in a step with `saturate` (did you mean `for`?)\n");
    EXPECT_EQ(findings_in_step("at = 1, saturate = \"CAN1\", id = 1"),
              "4:3: key-missing: `for` is missing in a step with `saturate`\n");
    EXPECT_EQ(findings_in_step("at = 1, saturate = \"CAN1\", id = 0x20000000, for = 1"),
              "4:37: key-value: `id` is 0x20000000, outside 0..536870911\n");
    EXPECT_EQ(findings_in_step("at = 1, switch = 811, on = 1"),
              "4:32: key-type: `on` must be true or false, not an integer\n");
    EXPECT_EQ(findings_in_step("at = 1, set = true, to = nan"),
              "4:19: key-type: `set` must be a sensor, by number or name, not a boolean\n"
              "4:30: key-value: `to` is nan, no number of a scenario\n");
}

TEST(ScenarioStep, knows_the_words_of_its_action) {
    EXPECT_EQ(findings_in_step("at = 1, reset = \"gatevay\""),
              "4:21: key-value: `reset` cannot be `gatevay` (did you mean `gateway`?)\n");
    EXPECT_EQ(findings_in_step("at = 1, drop = \"bus\""),
              "4:20: key-value: `drop` cannot be `bus` (it is one of CAN1, CAN2)\n");
    EXPECT_EQ(findings_in_step("at = 1, fault = \"can2-buss\""),
              "4:21: key-value: `fault` cannot be `can2-buss` (did you mean `can2-bus`?)\n");
}

TEST(ScenarioStep, names_errors_that_the_gateway_shows) {
    EXPECT_EQ(findings_in_step("at = 1, expect-error = \"canoptimectrlerr\""), "");
    EXPECT_EQ(findings_in_step("at = 1, expect-error = \"CanOpTimeCtrErr\""),
              "4:28: key-value: `CanOpTimeCtrErr` is no error that the gateway shows "
              "(did you mean `CanOpTimeCtrlErr`?)\n");
    EXPECT_EQ(findings_in_step("at = 1, expect-error = 12425"),
              "4:28: key-value: 12425 is no error that the gateway shows "
              "(errors are 3000..3095 and 12411..12424)\n");
    EXPECT_EQ(findings_in_step("at = 1, expect-error = \"any\"").find("4:28: key-value: `any`"), 0U);
    EXPECT_EQ(findings_in_step("at = 1, expect-no-error = \"any\""), "");
}

TEST(ScenarioStep, writes_objects_as_the_documents_do) {
    EXPECT_EQ(findings_in_step("at = 1, upload = \"1018H:1\""), "");
    EXPECT_EQ(findings_in_step("at = 1, upload = \"2005h\""), "");
    for (const char* text : {"1018", "1018h:", "1018h:256", "10180h:1", "h:1", "1018h:-1", "1018h1", "-1h"}) {
        EXPECT_EQ(findings_in_step(std::string("at = 1, upload = \"") + text + "\""),
                  std::string("4:22: key-value: `") + text +
                      "` is not written as an object "
                      "(write index and sub-index as 1018h:1, or the index alone as 2005h)\n");
    }
}

TEST(ScenarioSteps, stand_in_order_and_before_the_end) {
    EXPECT_EQ(findings_in(test::scenario_text("  { at = 2, reset = \"gateway\" },\n"
                                              "  { at = 1.5, reset = \"gateway\" },\n"
                                              "  { at = 2, reset = \"gateway\" },\n"
                                              "  { at = 20.1, reset = \"gateway\" },")),
              "5:10: step-time: this step is earlier than the one before it\n"
              "7:10: step-time: this step is later than the end of the scenario, 20 s "
              "(let `duration` be longer)\n");
}

TEST(ScenarioSteps, ask_before_they_expect_an_answer) {
    EXPECT_EQ(findings_in(test::scenario_text("  { at = 2, upload = \"1000h\" },\n"
                                              "  { at = 2, expect-answer = 0 },")),
              "5:10: step-answer: no `upload` or `write` comes before this `expect-answer`, "
              "at an earlier time\n");
    EXPECT_EQ(findings_in(test::scenario_text("  { at = 2, write = \"1000h\", value = 1 },\n"
                                              "  { at = 3, expect-abort = 0x06010002 },")),
              "");
}

TEST(ScenarioSteps, are_not_without_number) {
    std::string steps;
    for (std::size_t i = 0; i <= maximum_steps; ++i) {
        steps += "{at=1,reset=\"gateway\"},\n";
    }
    EXPECT_EQ(findings_in(test::scenario_text(steps)),
              "1004:1: key-value: the scenario has 1001 steps, more than 1000\n");
}

}  // namespace
}  // namespace cgw::scenario
