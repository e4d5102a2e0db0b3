#include "cli/canopen-gateway/display.hpp"

#include "support/sample_plant.hpp"

namespace cgw::gateway_cli {
namespace {

TEST(GatewayDisplay, cuts_long_lines_at_characters_not_bytes) {
    EXPECT_EQ(clipped("short", 10), "short");
    EXPECT_EQ(clipped("exactly10!", 10), "exactly10!");
    EXPECT_EQ(clipped("exactly11!!", 10), "exactly...");
    EXPECT_EQ(clipped("°°°°°°°°", 8), "°°°°°°°°");
    EXPECT_EQ(clipped("°°°°°°°°°", 8), "°°°°°...");
}

TEST(GatewayDisplay, explains_abort_codes) {
    EXPECT_EQ(abort_text(0x06010002), "abort 0x06010002, read-only object");
    EXPECT_EQ(abort_text(0x06020000), "abort 0x06020000, object does not exist");
    EXPECT_EQ(abort_text(0x12345678), "abort 0x12345678");
}

class GatewayDisplayValues : public testing::Test {
  protected:
    GatewayDisplayValues() { EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }
    test::SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
};

TEST_F(GatewayDisplayValues, shows_engineering_units_from_the_labels) {
    EXPECT_EQ(parameter_text(image_, 2000), "2000 Speed");
    EXPECT_EQ(value_text(image_, 2000, 24000), "1500 1/min");
}

TEST_F(GatewayDisplayValues, shows_a_part_of_the_range_without_scaling) {
    EXPECT_EQ(value_text(image_, 2300, 0x7FFF), "100.0 % of range");
    EXPECT_EQ(value_text(image_, 2300, 0x8000), "0.0 % of range");
}

TEST_F(GatewayDisplayValues, shows_the_number_of_a_parameter_without_a_name) {
    EXPECT_EQ(parameter_text(image_, 2101), "2101");
}

TEST_F(GatewayDisplayValues, names_states_and_pdos) {
    EXPECT_EQ(to_text(canopen::NmtState::pre_operational), "Pre-Operational");
    EXPECT_EQ(to_text(device::GatewayState::undefined), "Undefined");
    EXPECT_EQ(pdo_text(image_.pdo(0)), "TPDO1");
    EXPECT_EQ(pdo_text(image_.pdo(19)), "RPDO4");
}

}  // namespace
}  // namespace cgw::gateway_cli
