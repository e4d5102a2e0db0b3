// What each action does to the plant.
#include "scenario/stage.hpp"

namespace cgw::scenario {
namespace {

using device::GatewayState;
using test::Stage;

GatewayState state_of(Stage& stage) {
    return stage.installation.plant().gateway().state();
}

std::uint16_t canopen_errors(Stage& stage) {
    return stage.installation.plant().gateway().errors().canopen_errors();
}

constexpr unsigned bit_of(unsigned error) {
    return 1U << (error - facts::first_canopen_error);
}

TEST(ScenarioActions, without_any_the_plant_runs_up_and_is_healthy) {
    Stage stage("", "5");
    EXPECT_EQ(state_of(stage), GatewayState::operational);
    EXPECT_EQ(canopen_errors(stage), 0);
    EXPECT_EQ(stage.told(EventKind::state), "Init\nPre-Operational\nOperational\n");
    EXPECT_EQ(stage.told(EventKind::command), "start, node 12\n");
    EXPECT_EQ(stage.told(EventKind::boot_up), "node 12\n");
    EXPECT_EQ(stage.told(EventKind::engine), "starts\nruns\n");
    EXPECT_NEAR(stage.installation.plant().governor().engine().state().speed, 1500, 20);
}

TEST(ScenarioActions, set_sends_a_sensor_in_its_unit) {
    Stage stage("{ at = 3, set = \"AssignIn_AmbPress\", to = 850 },", "5");
    EXPECT_EQ(stage.told(EventKind::step), "the PLC sends 906 AssignIn_AmbPress at 850.0 mbar\n");
    const auto words = simulation::received_words(stage.installation.node(), test::genset());
    EXPECT_NEAR(words.at(2906), 65535.0 * (850 - 500) / 700, 2);
}

TEST(ScenarioActions, switch_knows_low_active_bits) {
    Stage stage(
        "{ at = 3, switch = 835, on = false },\n{ at = 3, switch = 811, on = true },\n"
        "{ at = 4, switch = 835, on = true },",
        "4");
    EXPECT_EQ(stage.told(EventKind::step),
              "the PLC switches 835 FunctLoadEnable off\nthe PLC switches 811 FunctIdleSpeed on\n"
              "the PLC switches 835 FunctLoadEnable on\n");
    EXPECT_EQ(stage.installation.plc().outputs()[0][0], 0x0001);  // bit 3, low-active, is 0 again
}

TEST(ScenarioActions, fail_and_repair_flag_a_sensor) {
    Stage failed("{ at = 3, fail = 903 },", "4");
    EXPECT_TRUE(failed.installation.plant().governor().inputs().sensor(903).faulty);
    EXPECT_FALSE(failed.installation.plant().governor().inputs().sensor(902).faulty);
    EXPECT_EQ(failed.told(EventKind::error, 1'000'000), "3008 comes\n");
    Stage repaired("{ at = 3, fail = 903 },\n{ at = 3.5, repair = 903 },", "4");
    EXPECT_FALSE(repaired.installation.plant().governor().inputs().sensor(903).faulty);
    EXPECT_EQ(repaired.told(EventKind::step), "the PLC flags 903\nthe PLC no longer flags 903\n");
}

TEST(ScenarioActions, silence_and_resume_stop_one_rpdo) {
    Stage silent("{ at = 3, silence = \"RPDO4\" },", "5");
    EXPECT_EQ(silent.told(EventKind::monitor), "RPDO4 is late\n");
    EXPECT_EQ(canopen_errors(silent), bit_of(12413));
    Stage resumed("{ at = 3, silence = \"RPDO4\" },\n{ at = 5, resume = \"RPDO4\" },", "6");
    EXPECT_EQ(resumed.told(EventKind::monitor), "RPDO4 is late\nRPDO4 is no longer late\n");
    EXPECT_EQ(canopen_errors(resumed), 0);
}

TEST(ScenarioActions, silence_stops_the_heartbeat_or_everything) {
    Stage heartbeat("{ at = 3, silence = \"heartbeat\" },", "6");
    EXPECT_EQ(heartbeat.told(EventKind::monitor), "the heartbeat of node 1 is lost\n");
    Stage all("{ at = 3, silence = \"all\" },\n{ at = 6, resume = \"all\" },", "7");
    EXPECT_EQ(all.told(EventKind::step),
              "the PLC stops sending RPDOs and heartbeat\nthe PLC sends RPDOs and heartbeat again\n");
    EXPECT_EQ(canopen_errors(all), 0);
    EXPECT_NE(all.told(EventKind::monitor).find("RPDO1 is late\n"), std::string::npos);
    EXPECT_NE(all.told(EventKind::monitor).find("the heartbeat of node 1 is no longer missed\n"),
              std::string::npos);
}

TEST(ScenarioActions, silence_stays_when_outputs_change) {
    Stage stage("{ at = 3, silence = \"RPDO2\" },\n{ at = 3.2, set = 902, to = 1 },", "5");
    EXPECT_EQ(canopen_errors(stage), bit_of(12413));
}

TEST(ScenarioActions, nmt_commands_the_gateway_or_all_nodes) {
    Stage stage(
        "{ at = 2, nmt = \"stop\" },\n{ at = 3, nmt = \"pre-operational\", to = \"all\" },\n"
        "{ at = 4, nmt = \"start\" },\n{ at = 5, nmt = \"reset-node\" },\n"
        "{ at = 7, nmt = \"reset-communication\" },",
        "8");
    EXPECT_EQ(stage.told(EventKind::command, 1'000'000),
              "stop, node 12\npre-operational, all nodes\nstart, node 12\nreset-node, node 12\n"
              "start, node 12\nreset-communication, node 12\nstart, node 12\n");
    EXPECT_EQ(stage.told(EventKind::state, 1'000'000),
              "Stopped\nPre-Operational\nOperational\nInit\nPre-Operational\nOperational\n"
              "Init\nPre-Operational\nOperational\n");
}

TEST(ScenarioActions, upload_and_write_tell_the_answer) {
    Stage stage(
        "{ at = 2, upload = \"1018h:1\" },\n{ at = 3, upload = \"2005h\" },\n"
        "{ at = 4, upload = \"3000h\" },\n{ at = 5, write = \"1017h\", value = 5, bytes = 4 },",
        "6");
    EXPECT_EQ(stage.told(EventKind::answer),
              "1018h:1: 0x00000161\n2005h:0: 0x0000\n"
              "3000h:0: abort 0x06020000, object does not exist\n"
              "1017h:0: abort 0x06070012, length too high\n");
}

TEST(ScenarioActions, drop_and_restore_cut_can2) {
    Stage cut("{ at = 3, drop = \"CAN2\" },\n{ at = 4, nmt = \"stop\" },", "5");
    EXPECT_EQ(state_of(cut), GatewayState::pre_operational);
    EXPECT_EQ(canopen_errors(cut), bit_of(12423));
    EXPECT_EQ(cut.told(EventKind::command, 1'000'000), "");
    EXPECT_EQ(cut.run->count().failed, 1U);
    EXPECT_NE(cut.told(EventKind::step).find("the PLC commands stop: the bus takes no frame\n"),
              std::string::npos);
    Stage mended(
        "{ at = 3, drop = \"CAN2\" },\n{ at = 4, restore = \"CAN2\" },\n{ at = 5, nmt = \"start\" },", "6");
    EXPECT_EQ(state_of(mended), GatewayState::operational);
    EXPECT_EQ(canopen_errors(mended), 0);
}

TEST(ScenarioActions, drop_and_restore_cut_can1) {
    Stage cut("{ at = 3, drop = \"CAN1\" },", "5");
    EXPECT_EQ(state_of(cut), GatewayState::undefined);
    EXPECT_EQ(canopen_errors(cut), bit_of(12421) | bit_of(12422));
    Stage mended("{ at = 3, drop = \"CAN1\" },\n{ at = 4, restore = \"CAN1\" },", "7");
    EXPECT_EQ(state_of(mended), GatewayState::operational);
    EXPECT_EQ(canopen_errors(mended), 0);
    EXPECT_EQ(mended.told(EventKind::boot_up), "node 12\nnode 12\n");
}

TEST(ScenarioActions, reset_interrupts_a_supply) {
    Stage stage("{ at = 3, reset = \"gateway\" },\n{ at = 6, reset = \"governor\" },", "9");
    EXPECT_NE(stage.told(EventKind::error).find("12419 CanOpGWResetErr, 3074 ErrCanOpen come\n"),
              std::string::npos);
    EXPECT_NE(stage.told(EventKind::error).find("12411 CanOpDCResetErr, 3074 ErrCanOpen come\n"),
              std::string::npos);
    EXPECT_EQ(stage.told(EventKind::boot_up), "node 12\nnode 12\nnode 12\n");
    EXPECT_EQ(state_of(stage), GatewayState::operational);
}

TEST(ScenarioActions, saturate_fills_a_bus_for_a_while) {
    Stage stage("{ at = 3, saturate = \"CAN2\", id = 0x1FFFFFFF, for = 0.5 },", "4");
    EXPECT_EQ(stage.told(EventKind::step), "CAN2 is full of 1FFFFFFFh for 0.5 s\n");
    const double before = 0.04 * 3'500'000;
    EXPECT_NEAR(static_cast<double>(stage.installation.plant().can2().busy_time()), 500'000 + before, 50'000);
    EXPECT_EQ(state_of(stage), GatewayState::operational);
    EXPECT_EQ(canopen_errors(stage), 0);  // an identifier that gives way to everybody
}

TEST(ScenarioActions, fault_and_mend_report_causes_to_the_devices) {
    struct Case {
        const char* name;
        unsigned error;
        GatewayState state;
    };
    for (const Case& row : {Case{"governor-can-bus", 12414, GatewayState::undefined},
                            Case{"governor-can-comm", 12415, GatewayState::undefined},
                            Case{"can1-bus", 12421, GatewayState::undefined},
                            Case{"can1-overflow", 12422, GatewayState::undefined},
                            Case{"can2-bus", 12423, GatewayState::pre_operational},
                            Case{"can2-overflow", 12424, GatewayState::undefined}}) {
        const std::string name = row.name;
        Stage there("{ at = 3, fault = \"" + name + "\" },", "4");
        EXPECT_EQ(canopen_errors(there), bit_of(row.error)) << name;
        EXPECT_EQ(state_of(there), row.state) << name;
        EXPECT_EQ(there.told(EventKind::step), "fault " + name + " appears\n");
        Stage gone("{ at = 3, fault = \"" + name + "\" },\n{ at = 4, mend = \"" + name +
                       "\" },\n{ at = 4.1, clear = \"governor\" },",
                   "8");
        EXPECT_EQ(canopen_errors(gone), 0) << name;
    }
}

TEST(ScenarioActions, clear_at_the_gateway_leaves_what_is_still_there) {
    Stage stage("{ at = 3, fault = \"can2-bus\" },\n{ at = 4, clear = \"gateway\" },", "5");
    EXPECT_EQ(canopen_errors(stage), bit_of(12423));
    Stage gone(
        "{ at = 3, fault = \"can2-bus\" },\n{ at = 4, mend = \"can2-bus\" },\n"
        "{ at = 4, expect-error = 12423 },\n{ at = 5, clear = \"gateway\" },",
        "6");
    EXPECT_EQ(canopen_errors(gone), 0);
    EXPECT_EQ(gone.run->count().failed, 0U);
}

}  // namespace
}  // namespace cgw::scenario
