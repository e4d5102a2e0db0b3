// What the device configuration file takes from the plant.
#include <gtest/gtest.h>

#include "plant.hpp"

namespace cgw::emit {
namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// 16 MHz, MCP2515, 500 kbit/s: CNF1..3 = 00 B5 01.
config::Configuration manual_timing() {
    config::Configuration configuration = test::manual_configuration();
    configuration.can2 = {.manual = true,
                          .bit_rate_kbit = 125,
                          .prescaler = 0,
                          .sync_jump_width = 0,
                          .sampling_mode = 0,
                          .phase_segment_1 = 6,
                          .phase_segment_2 = 1,
                          .prop_segment = 5};
    return configuration;
}

}  // namespace

TEST(EmitDcf, takes_node_title_and_names) {
    const test::SamplePlant plant(test::manual_configuration());
    const std::string text = plant.emit("dcf", "");
    EXPECT_TRUE(contains(text, "FileName=CANopenGateway.dcf\r\n"));
    EXPECT_TRUE(contains(text, "LastEDS=CANopenGateway.eds\r\n"));
    EXPECT_TRUE(contains(text, "NodeID=1\r\nNodeName=Genset 2, starboard\r\nBaudrate=125\r\n"));
    EXPECT_TRUE(contains(text, "Description=Genset 2, starboard, configuration 0123456789abcdef\r\n"));
}

TEST(EmitDcf, is_named_after_the_product_without_a_title) {
    const test::SamplePlant plant(test::manual_configuration(), "");
    EXPECT_TRUE(contains(plant.emit("dcf", ""), "NodeName=CANopen Gateway\r\n"));
}

TEST(EmitDcf, says_that_it_does_not_know_a_bit_rate_set_by_hand) {
    const test::SamplePlant plant(manual_timing());
    const std::string text = plant.emit("dcf", "");
    EXPECT_FALSE(contains(text, "Baudrate="));
    EXPECT_TRUE(contains(text, "=Baudrate is left out: the bit timing is set by hand (4426 = 1), and the "));
    EXPECT_TRUE(contains(text, "states no clock (bit_timing.can2)"));
}

TEST(EmitDcf, computes_a_bit_rate_set_by_hand_from_the_stated_clock) {
    test::SamplePlant plant(manual_timing());
    plant.settings.can2_bit_timing = {16'000'000, bit_timing::find_controller("mcp2515"), {}};
    EXPECT_TRUE(contains(plant.emit("dcf", ""), "\r\nBaudrate=500\r\n"));
}

TEST(EmitDcf, tells_a_bit_rate_that_is_no_whole_number_of_kbit) {
    test::SamplePlant plant(manual_timing());
    plant.configuration.can2.prescaler = 3;
    plant.configuration.can2.prop_segment = 4;
    plant.settings.can2_bit_timing = {16'000'000, bit_timing::find_controller("mcp2515"), {}};
    const std::string text = plant.emit("dcf", "");
    EXPECT_FALSE(contains(text, "Baudrate="));
    EXPECT_TRUE(contains(text, "=Baudrate is left out: the bit timing set by hand (4426 = 1) makes 133333 "));
    EXPECT_FALSE(contains(text, "states no clock"));
}

TEST(EmitDcf, carries_the_identity_or_says_that_it_is_not_stated) {
    test::SamplePlant without(test::manual_configuration());
    EXPECT_TRUE(contains(without.emit("dcf", ""), "1018h:3 and 1018h:4 are 0 because"));
    config::Configuration configuration = test::manual_configuration();
    configuration.identity = {104, 407, 1186};
    const test::SamplePlant with(configuration);
    const std::string text = with.emit("dcf", "");
    EXPECT_FALSE(contains(text, "1018h:3 and 1018h:4 are 0 because"));
    EXPECT_TRUE(contains(text, "LSS_SerialNumber=0x019704A2\r\n"));
}

}  // namespace cgw::emit
