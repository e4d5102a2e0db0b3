// Switches: 811 on bit 1, 835 low-active on bit 5. Sensors: 900 on channel 1, 906 on channel 7 (D25, D26,
// D55).
#include "simulation/inputs.hpp"

#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

class Inputs : public testing::Test {
  protected:
    Inputs() { EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }

    test::SamplePlant plant_;
    base::Bytes bytes_ = plant_.image();
    image::Image image_;
    CanopenInputs inputs_{image_};
};

TEST_F(Inputs, knows_only_the_switches_that_come_over_canopen) {
    EXPECT_EQ(inputs_.switch_function(812), std::nullopt);
    EXPECT_EQ(inputs_.switch_function(811), false);
}

TEST_F(Inputs, reads_high_and_low_active_switches) {
    inputs_.set_operational(true);
    inputs_.receive(1, {0x0001, 0, 0, 0});
    EXPECT_EQ(inputs_.switch_function(811), true);
    EXPECT_EQ(inputs_.switch_function(835), true);
    inputs_.receive(1, {0x0010, 0, 0, 0});
    EXPECT_EQ(inputs_.switch_function(811), false);
    EXPECT_EQ(inputs_.switch_function(835), false);
}

TEST_F(Inputs, takes_every_switch_as_zero_without_operational_or_rpdo1) {
    inputs_.receive(1, {0x0001, 0, 0, 0});
    EXPECT_EQ(inputs_.switch_function(811), false);
    EXPECT_EQ(inputs_.switch_function(835), false);  // low-active ones too
    inputs_.set_operational(true);
    EXPECT_EQ(inputs_.switch_function(835), false);
    inputs_.receive(2, {0, 0, 0, 0});  // another RPDO never affects switches
    EXPECT_EQ(inputs_.switch_function(835), false);
}

TEST_F(Inputs, reads_sensors_by_channel) {
    inputs_.set_operational(true);
    inputs_.receive(2, {0x1234, 0, 0, 0});
    inputs_.receive(3, {0, 0, 0x5678, 0});
    EXPECT_EQ(inputs_.sensor(900).word, 0x1234U);
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    EXPECT_EQ(inputs_.sensor(906).word, 0x5678U);
    EXPECT_FALSE(inputs_.sensor(905).carried);
}

TEST_F(Inputs, takes_a_sensor_as_faulty_until_its_own_rpdo_came) {
    inputs_.receive(2, {1, 0, 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    inputs_.set_operational(true);
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    inputs_.receive(3, {1, 0, 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    inputs_.receive(2, {1, 0, 0, 0});
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    inputs_.set_operational(false);
    EXPECT_TRUE(inputs_.sensor(900).faulty);
}

TEST_F(Inputs, obeys_the_error_flags_of_rpdo1) {
    inputs_.set_operational(true);
    inputs_.receive(2, {1, 0, 0, 0});
    inputs_.receive(3, {0, 0, 1, 0});
    inputs_.receive(1, {0, 0, 1U << 6, 0});
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    EXPECT_TRUE(inputs_.sensor(906).faulty);
    inputs_.receive(1, {0, 0, 1U << 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    EXPECT_FALSE(inputs_.sensor(906).faulty);
}

}  // namespace
}  // namespace cgw::simulation
