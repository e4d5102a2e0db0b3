// Switches: 811 on bit 1, 835 low-active on bit 5. Sensors: 900 on channel 1, 906 on channel 7 (D25, D26,
// D55).
#include "simulation/inputs.hpp"

#include "support/sample_plant.hpp"

namespace cgw::simulation {
namespace {

class Inputs : public testing::Test {
  protected:
    Inputs() { EXPECT_EQ(image::Image::open(bytes_, image_), image::Status::ok); }

    void operational(std::uint8_t late_rpdos = 0, bool heartbeat_lost = false) {
        device::GatewayStatus status;
        status.state = device::GatewayState::operational;
        status.late_rpdos = late_rpdos;
        status.heartbeat_lost = heartbeat_lost;
        inputs_.follow(status);
    }
    void pre_operational() {
        device::GatewayStatus status;
        status.state = device::GatewayState::pre_operational;
        inputs_.follow(status);
    }

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
    operational();
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
    operational();
    EXPECT_EQ(inputs_.switch_function(835), false);
    inputs_.receive(2, {0, 0, 0, 0});  // another RPDO never affects switches
    EXPECT_EQ(inputs_.switch_function(835), false);
}

TEST_F(Inputs, reads_sensors_by_channel) {
    operational();
    inputs_.receive(2, {0x1234, 0, 0, 0});
    inputs_.receive(3, {0, 0, 0x5678, 0});
    EXPECT_EQ(inputs_.sensor(900).word, 0x1234U);
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    EXPECT_EQ(inputs_.sensor(906).word, 0x5678U);
    EXPECT_FALSE(inputs_.sensor(905).carried);
}

TEST_F(Inputs, takes_an_unmonitored_sensor_as_faulty_until_its_own_rpdo_came) {
    inputs_.receive(2, {1, 0, 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    operational();
    EXPECT_TRUE(inputs_.sensor(906).faulty);
    inputs_.receive(2, {1, 0, 0, 0});
    EXPECT_TRUE(inputs_.sensor(906).faulty);
    inputs_.receive(3, {0, 0, 1, 0});
    EXPECT_FALSE(inputs_.sensor(906).faulty);
    pre_operational();
    EXPECT_TRUE(inputs_.sensor(906).faulty);
}

TEST_F(Inputs, obeys_the_error_flags_of_rpdo1) {
    operational();
    inputs_.receive(2, {1, 0, 0, 0});
    inputs_.receive(3, {0, 0, 1, 0});
    inputs_.receive(1, {0, 0, 1U << 6, 0});
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    EXPECT_TRUE(inputs_.sensor(906).faulty);
    inputs_.receive(1, {0, 0, 1U << 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    EXPECT_FALSE(inputs_.sensor(906).faulty);
}

// RPDO2 is monitored: before its time is over a sensor is not faulty, but has no value either.
TEST_F(Inputs, waits_for_the_first_value_of_a_monitored_sensor) {
    operational();
    EXPECT_FALSE(inputs_.sensor(900).faulty);
    EXPECT_FALSE(inputs_.sensor(900).usable());
    inputs_.receive(2, {1, 0, 0, 0});
    EXPECT_TRUE(inputs_.sensor(900).usable());
}

TEST_F(Inputs, takes_the_sensors_of_a_late_rpdo_as_faulty) {
    operational();
    inputs_.receive(2, {1, 0, 0, 0});
    inputs_.receive(3, {0, 0, 1, 0});
    operational(0b0010);
    EXPECT_TRUE(inputs_.sensor(900).faulty);
    EXPECT_FALSE(inputs_.sensor(906).faulty);
    operational();
    EXPECT_TRUE(inputs_.sensor(900).usable());  // what was received is not forgotten
}

TEST_F(Inputs, trusts_nothing_when_rpdo1_is_late_or_the_heartbeat_is_lost) {
    for (const bool heartbeat_lost : {false, true}) {
        operational();
        inputs_.receive(1, {0x0001, 0, 0, 0});
        inputs_.receive(2, {1, 0, 0, 0});
        inputs_.receive(3, {0, 0, 1, 0});
        EXPECT_EQ(inputs_.switch_function(811), true);
        operational(heartbeat_lost ? 0 : 0b0001, heartbeat_lost);
        EXPECT_EQ(inputs_.switch_function(811), false);
        EXPECT_EQ(inputs_.switch_function(835), false);  // low-active ones too
        EXPECT_TRUE(inputs_.sensor(900).faulty);
        EXPECT_TRUE(inputs_.sensor(906).faulty);
    }
}

TEST_F(Inputs, keeps_switches_when_another_rpdo_is_late) {
    operational();
    inputs_.receive(1, {0x0001, 0, 0, 0});
    operational(0b1110);
    EXPECT_EQ(inputs_.switch_function(811), true);
}

}  // namespace
}  // namespace cgw::simulation
