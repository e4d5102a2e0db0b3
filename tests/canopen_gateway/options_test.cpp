#include "cli/canopen-gateway/options.hpp"

#include <sstream>

namespace cgw::gateway_cli {
namespace {

std::string error_of(const std::vector<const char*>& arguments) {
    Options options;
    std::string error;
    EXPECT_FALSE(parse_options(arguments, options, error)) << arguments.front();
    return error;
}

TEST(GatewayOptions, reads_every_option) {
    const std::vector<const char*> arguments = {"--can1", "simulated", "--can2",     "virtual", "--master",
                                                "--log",  "run.log",   "--duration", "2.5"};
    Options options;
    std::string error;
    ASSERT_TRUE(parse_options(arguments, options, error)) << error;
    EXPECT_TRUE(options.master);
    EXPECT_EQ(options.log, "run.log");
    EXPECT_EQ(options.duration_us, 2'500'000U);
    EXPECT_FALSE(options.help);
}

TEST(GatewayOptions, reads_values_after_an_equals_sign) {
    const std::vector<const char*> arguments = {"--can1=simulated", "--log=a=b", "--duration=86400"};
    Options options;
    std::string error;
    ASSERT_TRUE(parse_options(arguments, options, error)) << error;
    EXPECT_EQ(options.log, "a=b");
    EXPECT_EQ(options.duration_us, 86'400'000'000U);
}

TEST(GatewayOptions, runs_ten_seconds_by_default) {
    Options options;
    std::string error;
    EXPECT_TRUE(parse_options({}, options, error));
    EXPECT_FALSE(options.duration_us.has_value());
    EXPECT_EQ(simulated_duration_us, 10'000'000U);
    EXPECT_FALSE(options.real_time());
}

TEST(GatewayOptions, runs_in_real_time_with_a_can_bus_on_either_side) {
    for (const std::vector<const char*>& arguments :
         {std::vector<const char*>{"--can2", "hub:127.0.0.1:29536/can0", "--state", "s", "--status"},
          {"--can1", "socketcan:can0", "--status"},
          {"--can2", "slcan:/dev/ttyACM0@250"}}) {
        Options options;
        std::string error;
        ASSERT_TRUE(parse_options(arguments, options, error)) << error;
        EXPECT_TRUE(options.real_time());
    }
}

TEST(GatewayOptions, refuses_what_does_not_go_together) {
    EXPECT_EQ(error_of({"--can2", "hub:localhost:1", "--master"}),
              "--master is for simulated time; on a real bus the master is another program");
    EXPECT_EQ(error_of({"--can2", "hub:localhost:1", "--log", "x", "--state", "x"}),
              "--log and --state are the same file");
    EXPECT_EQ(error_of({"--status"}), "--status is for real time: give --can1 or --can2 a CAN bus");
    EXPECT_EQ(error_of({"--state", "s"}), "--state is for real time: give --can1 or --can2 a CAN bus");
}

TEST(GatewayOptions, refuses_the_same_bus_on_both_sides) {
    EXPECT_EQ(error_of({"--can1", "hub:localhost:1", "--can2", "hub:localhost:1/can0"}),
              "--can1 and --can2 are the same bus, hub:localhost:1; a gateway joins two");
    EXPECT_NE(error_of({"--can1=socketcan:can0", "--can2=socketcan:can0"}), "");
    EXPECT_NE(error_of({"--can1=slcan:/dev/ttyACM0@250", "--can2=slcan:/dev/ttyACM0@125"}), "");
    Options options;
    std::string error;
    for (const std::vector<const char*>& two :
         {std::vector<const char*>{"--can1=hub:localhost:1/can1", "--can2=hub:localhost:1/can2"},
          {"--can1=socketcan:can0", "--can2=socketcan:can1"},
          {"--can1=simulated", "--can2=virtual"}}) {
        EXPECT_TRUE(parse_options(two, options, error)) << error;
    }
}

TEST(GatewayOptions, refuses_an_option_given_twice) {
    EXPECT_EQ(error_of({"--log", "a.log", "--log=b.log"}), "--log is given twice: a.log and b.log");
    Options options;
    std::string error;
    const std::vector<const char*> flags = {"--master", "--master"};
    EXPECT_TRUE(parse_options(flags, options, error)) << error;
}

TEST(GatewayOptions, refuses_unknown_options_and_stray_words) {
    EXPECT_EQ(error_of({"--foo"}), "unknown option '--foo', --help lists them");
    EXPECT_EQ(error_of({"--foo=1"}), "unknown option '--foo', --help lists them");
    EXPECT_EQ(error_of({"run.log"}), "unknown option 'run.log', --help lists them");
    EXPECT_EQ(error_of({""}), "unknown option '', --help lists them");
}

TEST(GatewayOptions, refuses_media_it_does_not_have) {
    EXPECT_EQ(error_of({"--can1", "virtual"}),
              "--can1 'virtual': expected simulated or a CAN bus, --help says how it is written");
    for (const char* text : {"simulated", "hub", "usb:0", "", ":can0"}) {
        EXPECT_EQ(error_of({"--can2", text}),
                  "--can2 '" + std::string(text) +
                      "': expected virtual or a CAN bus, --help says how it is written");
    }
}

TEST(GatewayOptions, refuses_missing_and_superfluous_values) {
    EXPECT_EQ(error_of({"--log"}), "--log '': expected a file name");
    EXPECT_EQ(error_of({"--log="}), "--log '': expected a file name");
    EXPECT_EQ(error_of({"--state", "-"}), "--state '-': expected a file name");
    EXPECT_EQ(error_of({"--master=yes"}), "--master takes no value");
}

TEST(GatewayOptions, refuses_durations_that_are_none) {
    for (const char* text : {"", "0", "-1", "abc", "1s", "86401", "nan", "inf", "1e3", "0.0000001", " 1"}) {
        EXPECT_NE(error_of({"--duration", text}).find("expected a number above 0, up to 86400"),
                  std::string::npos)
            << text;
    }
}

TEST(GatewayOptions, names_every_option_in_the_help_within_eighty_columns) {
    const std::string help = help_text();
    for (const char* name : {"--can1", "--can2", "--master", "--log", "--state", "--status", "--duration",
                             "--version", "--help", "hub:HOST:PORT[/BUS]", "SIGUSR1"}) {
        EXPECT_NE(help.find(name), std::string::npos) << name;
    }
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 80U) << line;
    }
}

}  // namespace
}  // namespace cgw::gateway_cli
