// Steps name what the plant has.
#include "scenario/stage.hpp"

namespace cgw::scenario {
namespace {

std::string findings_in_step(const std::string& step) {
    diagnostic::Findings findings;
    Scenario scenario = read_scenario(test::scenario_text("  { at = 1, " + step + " },"), "t.toml", findings);
    EXPECT_EQ(test::findings_text(findings), "");
    bind(scenario, test::genset(), findings);
    return test::findings_text(findings);
}

TEST(ScenarioNames, are_numbers_or_names_of_the_plant) {
    for (const char* step : {"fail = 902", "fail = \"assignin_setp1ext\"", "fail = \"AmbientPressure\"",
                             "fail = \"902\"", "fail = \"900 AssignIn_Setp1Ext\"", "switch = 835, on = true",
                             "switch = \"FunctLoadEnable\", on = true", "expect-word = 2905, min = 1",
                             "expect-word = \"OilPressure\", min = 1"}) {
        EXPECT_EQ(findings_in_step(step), "") << step;
    }
}

TEST(ScenarioNames, that_the_plant_does_not_have_are_refused) {
    EXPECT_EQ(findings_in_step("fail = 905"),
              "4:20: step-subject: 905 is no sensor that comes over CANopen in this plant (its sensors are "
              "900 AssignIn_Setp1Ext, 902, 903, 906 AssignIn_AmbPress, 910, 917 AssignIn_CurrentLoad)\n");
    EXPECT_EQ(findings_in_step("fail = \"AssignIn_Setp2Ext\""),
              "4:20: step-subject: `AssignIn_Setp2Ext` is no sensor that comes over CANopen in this plant "
              "(did you mean `AssignIn_Setp1Ext`?)\n");
    EXPECT_EQ(findings_in_step("switch = 812, on = true"),
              "4:22: step-subject: 812 is no switch function that comes over CANopen in this plant (its "
              "switch functions are 811 FunctIdleSpeed, 827 FunctSetpoint2Or1, 835 FunctLoadEnable)\n");
    EXPECT_EQ(findings_in_step("expect-word = \"OilPresure\", min = 1"),
              "4:27: step-subject: `OilPresure` is in no active TPDO of this plant "
              "(did you mean `OilPressure`?)\n");
    EXPECT_EQ(findings_in_step("expect-tpdo = 7, within = 1"),
              "4:27: step-subject: TPDO7 is not active in this plant\n");
}

TEST(ScenarioNames, need_an_active_rpdo_and_a_watched_heartbeat) {
    const test::Configuration minimal(CGW_SAMPLES "/minimal.toml");
    diagnostic::Findings findings;
    Scenario scenario = read_scenario(
        test::scenario_text("{ at = 1, silence = \"RPDO1\" },\n"
                            "{ at = 1, resume = \"heartbeat\" },\n{ at = 1, silence = \"all\" },\n"
                            "{ at = 1, fail = 900 },"),
        "t.toml", findings);
    bind(scenario, minimal.image, findings);
    EXPECT_EQ(test::findings_text(findings),
              "4:21: step-subject: RPDO1 is not active in this plant\n"
              "5:20: step-subject: the gateway watches no heartbeat in this plant\n"
              "7:18: step-subject: 900 is no sensor that comes over CANopen in this plant "
              "(it has no sensors)\n");
}

TEST(ScenarioValues, fit_into_their_words) {
    EXPECT_EQ(findings_in_step("set = 906, to = 1200"), "");
    EXPECT_EQ(findings_in_step("set = 906, to = 1201"),
              "4:29: step-value: 906 AssignIn_AmbPress cannot be 1201, it reaches from 500 to 1200 mbar\n");
    EXPECT_EQ(findings_in_step("set = 902, to = -0.1"),
              "4:29: step-value: 902 cannot be -0.1, it reaches from 0 to 100 % of range\n");
    EXPECT_EQ(findings_in_step("write = \"1017h\", value = 65536"),
              "4:38: step-value: 65536 does not fit into 2 bytes\n");
    EXPECT_EQ(findings_in_step("write = \"1017h\", value = 65536, bytes = 4"), "");
    EXPECT_EQ(findings_in_step("write = \"1017h\", value = 1, bytes = 3"),
              "4:38: step-value: an expedited transfer of this PLC has 1, 2 or 4 bytes\n");
}

TEST(ScenarioRanges, have_two_ends_the_right_way_round) {
    EXPECT_EQ(findings_in_step("expect-engine = \"speed\", min = 2, max = 1"),
              "4:44: step-value: `min` 2 is greater than `max` 1\n");
    EXPECT_NE(findings_in_step("expect-engine = \"speed\"").find("step-value: give `min`, `max` or both"),
              std::string::npos);
    EXPECT_EQ(findings_in_step("expect-engine = \"speed\", max = 0"), "");
}

}  // namespace
}  // namespace cgw::scenario
