// Each expectation is met when it should be, and says what it found when it is not.
#include "scenario/stage.hpp"

namespace cgw::scenario {
namespace {

// What the expectations at 4 s, on a healthy plant, say.
std::string said(const std::string& expectations, const std::string& before = "") {
    const test::Stage stage(before + expectations, "5");
    std::string text;
    for (const Event& event : stage.events) {
        if (event.kind == EventKind::expected) {
            text += (event.bad ? "FAILED " : "ok ") + event.text + "\n";
        }
    }
    return text;
}

TEST(ScenarioExpectations, of_the_state) {
    EXPECT_EQ(said("{ at = 4, expect-state = \"operational\" },\n{ at = 4, expect-state = \"stopped\" },"),
              "ok the gateway is Operational\nFAILED expected: the gateway is Stopped; it is Operational\n");
}

TEST(ScenarioExpectations, of_errors) {
    EXPECT_EQ(
        said("{ at = 4, expect-error = 12413 },\n{ at = 4, expect-no-error = 12413 },\n"
             "{ at = 4, expect-no-error = \"any\" },"),
        "FAILED expected: error 12413 CanOpTimeCtrlErr; there is none\nok no error 12413 CanOpTimeCtrlErr\n"
        "ok no error\n");
    EXPECT_EQ(said("{ at = 4, expect-error = \"ErrSetpointExtern\" },\n{ at = 4, expect-error = 12413 },\n"
                   "{ at = 4, expect-no-error = 3005 },\n{ at = 4, expect-no-error = \"any\" },",
                   "{ at = 3, fail = 900 },"),
              "ok error 3005 ErrSetpointExtern\n"
              "FAILED expected: error 12413 CanOpTimeCtrlErr; there is only 3005 ErrSetpointExtern\n"
              "FAILED expected: no error 3005 ErrSetpointExtern; it is there\n"
              "FAILED expected: no error; there is 3005 ErrSetpointExtern\n");
}

TEST(ScenarioExpectations, of_words) {
    EXPECT_EQ(
        said("{ at = 4, expect-word = \"Speed\", min = 1490, max = 1510 },\n"
             "{ at = 4, expect-word = \"Speed\", min = 1600 },\n"
             "{ at = 4, expect-word = \"Speed\", max = 0.5 },"),
        "ok 2000 Speed 1490..1510 1/min\nFAILED expected: 2000 Speed at least 1600 1/min; it is 1500 1/min\n"
        "FAILED expected: 2000 Speed at most 0.5 1/min; it is 1500 1/min\n");
    EXPECT_EQ(said("{ at = 0.1, expect-word = \"Speed\", min = 0 },"),
              "FAILED expected: 2000 Speed at least 0 1/min; not received\n");
}

TEST(ScenarioExpectations, of_the_engine) {
    EXPECT_EQ(
        said("{ at = 4, expect-engine = \"load\", min = 59, max = 61 },\n"
             "{ at = 4, expect-engine = \"oil-pressure\", max = 1 },"),
        "ok engine load 59..61 %\nFAILED expected: engine oil-pressure at most 1 bar; it is 4.39 bar\n");
}

TEST(ScenarioExpectations, of_alarms) {
    EXPECT_EQ(said("{ at = 4, expect-alarm = \"overspeed\" },\n{ at = 4, expect-no-alarm = \"overspeed\" },\n"
                   "{ at = 4, expect-no-alarm = \"any\" },"),
              "FAILED expected: alarm overspeed; there is none\nok no alarm overspeed\nok no alarm\n");
    EXPECT_EQ(
        said("{ at = 4.9, expect-alarm = \"overspeed\" },\n{ at = 4.9, expect-alarm = \"hot-coolant\" },\n"
             "{ at = 4.9, expect-no-alarm = \"overspeed\" },\n{ at = 4.9, expect-no-alarm = \"any\" },",
             "{ at = 3.5, fault = \"actuator-stuck\" },\n{ at = 3.5, fault = \"load-rejection\" },\n"),
        "ok alarm overspeed\nFAILED expected: alarm coolant is hot; there is only overspeed\n"
        "FAILED expected: no alarm overspeed; it is there\nFAILED expected: no alarm; there is overspeed\n");
}

TEST(ScenarioExpectations, of_the_engine_state_in_tpdo3) {
    EXPECT_EQ(
        said("{ at = 4, expect-status = \"running\", on = true },\n"
             "{ at = 4, expect-status = \"running\", on = false },\n"
             "{ at = 4, expect-status = \"emergency-stop\", on = false },\n"
             "{ at = 4, expect-status = \"emergency-stop\", on = true },",
             "{ at = 0.1, expect-status = \"standing\", on = true },\n"),
        "FAILED expected: TPDO3 says standing; not received\n"
        "ok TPDO3 says running\nFAILED expected: TPDO3 says not running; its word is 0x1C\n"
        "ok TPDO3 says not emergency-stop\nFAILED expected: TPDO3 says emergency-stop; its word is 0x1C\n");
}

TEST(ScenarioExpectations, of_tpdos) {
    EXPECT_EQ(said("{ at = 4.001, expect-tpdo = 4, within = 0.125 },\n"
                   "{ at = 4.001, expect-tpdo = 4, within = 0.001 },\n"
                   "{ at = 4.001, expect-no-tpdo = 4, within = 1 },",
                   "{ at = 0.2, expect-no-tpdo = 4, within = 0.2 },\n"
                   "{ at = 0.2, expect-tpdo = 4, within = 0.2 },\n"),
              "ok no TPDO4 within 0.2 s\nFAILED expected: TPDO4 within 0.2 s; there was none\n"
              "ok TPDO4 within 0.125 s\n"
              "FAILED expected: TPDO4 within 0.001 s; the last one is 0.124 s old\n"
              "FAILED expected: no TPDO4 within 1 s; the last one is 0.124 s old\n");
}

TEST(ScenarioExpectations, of_heartbeats_and_boot_ups) {
    EXPECT_EQ(said("{ at = 4, expect-heartbeat = \"operational\", within = 0.8 },\n"
                   "{ at = 4, expect-heartbeat = \"stopped\", within = 0.8 },\n"
                   "{ at = 4, expect-boot-ups = 1 },\n{ at = 4, expect-boot-ups = 2 },",
                   "{ at = 0.2, expect-heartbeat = \"operational\", within = 0.2 },"),
              "FAILED expected: heartbeat Operational within 0.2 s; there was none\n"
              "ok heartbeat Operational within 0.8 s\n"
              "FAILED expected: heartbeat Stopped within 0.8 s; it says Operational\n"
              "ok 1 boot-up so far\nFAILED expected: 2 boot-ups so far; there was 1\n");
}

TEST(ScenarioExpectations, of_answers) {
    EXPECT_EQ(said("{ at = 4, expect-answer = 353 },\n{ at = 4, expect-answer = 1 },\n"
                   "{ at = 4, expect-abort = 0x06010002 },",
                   "{ at = 3, upload = \"1018h:1\" },"),
              "ok answer 0x161\nFAILED expected: answer 0x1; it is 0x00000161\n"
              "FAILED expected: abort 0x06010002, read-only object; it is 0x00000161\n");
    EXPECT_EQ(said("{ at = 4, expect-abort = 0x06010002 },\n{ at = 4, expect-abort = 0x06020000 },\n"
                   "{ at = 4, expect-answer = 1 },",
                   "{ at = 3, write = \"1018h:1\", value = 1, bytes = 4 },"),
              "ok abort 0x06010002, read-only object\n"
              "FAILED expected: abort 0x06020000, object does not exist; abort 0x06010002, read-only object\n"
              "FAILED expected: answer 0x1; abort 0x06010002, read-only object\n");
    EXPECT_EQ(said("{ at = 4, expect-answer = 1 },",
                   "{ at = 3, drop = \"CAN2\" },\n"
                   "{ at = 3.5, upload = \"1018h:1\" },"),
              "FAILED expected: answer 0x1; there is no answer yet\n");
}

}  // namespace
}  // namespace cgw::scenario
