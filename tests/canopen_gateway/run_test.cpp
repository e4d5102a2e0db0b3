// The program as its users run it, with images of its own.
#include "cli/canopen-gateway/run.hpp"

#include <filesystem>
#include <set>
#include <sstream>

#include "media/candump.hpp"
#include "media/log.hpp"
#include "media/pcap.hpp"
#include "support/golden.hpp"
#include "support/sample_plant.hpp"

namespace cgw::gateway_cli {
namespace {

struct Outcome {
    int code = 0;
    std::string out;
    std::string error;
};

Outcome run_with(const base::Bytes& image, const std::vector<const char*>& arguments) {
    std::ostringstream out;
    std::ostringstream error;
    const int code = run(arguments, image, out, error);
    return {code, out.str(), error.str()};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

std::size_t columns(const std::string& line) {
    return static_cast<std::size_t>(std::count_if(
        line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

class GatewayRun : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(directory_); }
    void TearDown() override { std::filesystem::remove_all(directory_); }
    std::string path(const char* name) const { return (directory_ / name).string(); }

    std::filesystem::path directory_ =
        std::filesystem::path(testing::TempDir()) /
        ("cgw_gateway_run_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    test::SamplePlant plant_;
};

TEST_F(GatewayRun, shows_what_a_master_sees) {
    const Outcome outcome = run_with(plant_.image(), {"--master"});
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_TRUE(outcome.error.empty());
    for (const char* part :
         {"Genset 2, starboard", "boot-up of node 5", "1000h:0 device type    0x00020191",
          "1018h:1 vendor         0x00000161", "1018h:4 serial number  0x01970102",
          "the gateway is Operational", "TPDO4 485h every 15.625 ms", "2000 Speed", "1/min",
          "RPDO2 305h changes 900 AssignIn_Setp1Ext", "RPDO1 205h switches 835",
          "abort 0x06010002, read-only object",
          "heartbeats: ", "one every 1008 ms, the last one says Operational", "frames on CAN2, bus load"}) {
        EXPECT_TRUE(contains(outcome.out, part)) << part << "\n" << outcome.out;
    }
}

TEST_F(GatewayRun, shows_a_receive_pdo_taking_effect) {
    const Outcome outcome = run_with(plant_.image(), {"--master"});
    const std::size_t change = outcome.out.find("RPDO2 305h changes");
    ASSERT_NE(change, std::string::npos);
    const std::size_t speed = outcome.out.find("2000 Speed", change);
    ASSERT_NE(speed, std::string::npos) << outcome.out;
    EXPECT_TRUE(contains(outcome.out.substr(speed, 80), "1/min -> 1665 1/min")) << outcome.out;
}

TEST_F(GatewayRun, keeps_every_line_within_eighty_columns) {
    plant_.settings.title = std::string(200, 'x');
    plant_.speed.name = "AVeryLongNameOfAParameterThatNobodyWouldEverWantToReadInATableOfValues";
    plant_.setpoint.name = plant_.speed.name;
    std::istringstream lines(run_with(plant_.image(), {"--master"}).out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(columns(line), 80U) << line;
    }
}

TEST_F(GatewayRun, works_without_labels) {
    const Outcome outcome = run_with(plant_.image(false), {"--master"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(contains(outcome.out, "% of range"));
    EXPECT_FALSE(contains(outcome.out, "Speed"));
}

TEST_F(GatewayRun, works_without_process_data_and_heartbeat) {
    plant_.configuration.send_errors = false;
    plant_.configuration.switches.clear();
    plant_.configuration.sensors.clear();
    plant_.configuration.heartbeat_producer = {};
    for (config::Pdo& pdo : plant_.configuration.pdos) {
        pdo.active = false;
        pdo.mapping.clear();
    }
    const Outcome outcome = run_with(plant_.image(), {"--master"});
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "no transmit PDO is active in this configuration"));
    EXPECT_TRUE(contains(outcome.out, "no receive PDO is active in this configuration"));
    EXPECT_TRUE(contains(outcome.out, "heartbeat: off in this configuration"));
}

TEST_F(GatewayRun, reports_missing_identity_objects_and_goes_on) {
    std::erase_if(plant_.dictionary.objects,
                  [](const auto& object) { return object.index == 0x1018 || object.index == 0x1017; });
    const Outcome outcome = run_with(plant_.image(), {"--master"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(contains(outcome.out, "1018h:1 vendor         abort 0x06020000, object does not exist"));
    EXPECT_TRUE(contains(outcome.out, "SDO write to 1017h:0: abort 0x06020000, object does not exist"));
}

TEST_F(GatewayRun, stops_when_the_duration_ends_in_any_step) {
    for (const char* duration : {"0.2", "0.5", "3.5", "5.2", "7.06"}) {
        const Outcome outcome = run_with(plant_.image(), {"--master", "--duration", duration});
        EXPECT_EQ(outcome.code, 0) << duration << outcome.out;
        EXPECT_TRUE(contains(outcome.out, "frames on CAN2")) << duration;
    }
}

TEST_F(GatewayRun, is_no_success_when_the_duration_ends_before_the_gateway_is_started) {
    for (const char* duration : {"0.000001", "0.01", "0.049"}) {
        const Outcome outcome = run_with(plant_.image(), {"--master", "--duration", duration});
        EXPECT_EQ(outcome.code, 1) << duration << outcome.out;
        EXPECT_TRUE(contains(outcome.out, ": the run is over, --duration is too short")) << outcome.out;
        EXPECT_TRUE(contains(outcome.out, "frames on CAN2")) << duration;
    }
    EXPECT_EQ(run_with(plant_.image(), {"--duration", "0.01"}).code, 0);  // nobody asked for anything
}

TEST_F(GatewayRun, runs_without_a_master) {
    const Outcome outcome = run_with(plant_.image(), {"--duration", "3"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(contains(outcome.out, "gateway Pre-Operational"));
    EXPECT_TRUE(contains(outcome.out, "boot-ups 1, heartbeats 2"));
}

TEST_F(GatewayRun, refuses_a_damaged_image_with_the_reason) {
    base::Bytes bytes = plant_.image();
    bytes[bytes.size() / 2] ^= 1U;
    const Outcome outcome = run_with(bytes, {"--master"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(
        outcome.error,
        "canopen-gateway: the embedded configuration is refused: the CRC-32 does not match (status 7)\n");
    EXPECT_TRUE(outcome.out.empty());
}

TEST_F(GatewayRun, refuses_an_image_the_gateway_cannot_run) {
    std::erase_if(plant_.dictionary.objects, [](const auto& object) { return object.index == 0x2005; });
    const Outcome outcome = run_with(plant_.image(), {});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.error,
              "canopen-gateway: the embedded configuration is refused: an object that the gateway writes is "
              "missing\n");
}

TEST_F(GatewayRun, refuses_a_wrong_command_line) {
    const Outcome outcome = run_with(plant_.image(), {"--can2", "hub"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(
        outcome.error,
        "canopen-gateway: --can2 'hub': expected virtual or a CAN bus, --help says how it is written\n");
    EXPECT_TRUE(outcome.out.empty());
}

TEST_F(GatewayRun, prints_help_and_version_without_looking_at_the_image) {
    EXPECT_TRUE(contains(run_with({}, {"--help"}).out, "usage: canopen-gateway"));
    EXPECT_EQ(run_with({}, {"--help"}).code, 0);
    EXPECT_EQ(run_with({}, {"--version"}).out.find("canopen-gateway "), 0U);
}

TEST_F(GatewayRun, writes_every_frame_to_the_log_and_the_same_log_again) {
    const std::string first = path("first.log");
    const std::string second = path("second.log");
    ASSERT_EQ(run_with(plant_.image(), {"--master", "--log", first.c_str()}).code, 0);
    ASSERT_EQ(run_with(plant_.image(), {"--master", "--log", second.c_str()}).code, 0);
    const std::string text = test::read_text(first);
    EXPECT_EQ(text, test::read_text(second));
    std::istringstream lines(text);
    std::size_t count = 0;
    std::uint64_t last = 0;
    std::set<std::string> seen;
    for (std::string line; std::getline(lines, line); ++count) {
        const auto logged = media::parse_candump_line(line);
        ASSERT_TRUE(logged.has_value()) << line;
        EXPECT_GE(logged->time_us, last);
        last = logged->time_us;
        seen.insert(logged->interface_name);
    }
    EXPECT_GT(count, 500U);
    EXPECT_EQ(seen, (std::set<std::string>{"can1", "can2"}));
}

TEST_F(GatewayRun, writes_a_pcap_log_when_its_name_says_so) {
    const std::string text = path("run.log");
    const std::string pcap = path("run.pcap");
    ASSERT_EQ(run_with(plant_.image(), {"--duration", "1", "--log", text.c_str()}).code, 0);
    ASSERT_EQ(run_with(plant_.image(), {"--duration", "1", "--log", pcap.c_str()}).code, 0);
    const auto from_text = media::read_log(test::read_text(text), text);
    const auto from_pcap = media::read_log(test::read_text(pcap), pcap);
    ASSERT_TRUE(from_text && from_pcap);
    ASSERT_TRUE(media::is_pcap(test::read_text(pcap)));
    ASSERT_EQ(from_text->frames.size(), from_pcap->frames.size());
    EXPECT_EQ(from_text->frames.back().frame, from_pcap->frames.back().frame);
    EXPECT_EQ(from_text->frames.back().time_us, from_pcap->frames.back().time_us);
}

TEST_F(GatewayRun, leaves_nothing_behind_when_the_log_cannot_be_written) {
    const std::string log = path("missing/run.log");
    const Outcome outcome = run_with(plant_.image(), {"--log", log.c_str(), "--duration", "1"});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_TRUE(contains(outcome.error, "canopen-gateway: ")) << outcome.error;
    EXPECT_TRUE(contains(outcome.error, log)) << outcome.error;
    EXPECT_TRUE(std::filesystem::is_empty(directory_));
}

}  // namespace
}  // namespace cgw::gateway_cli
