#include <gtest/gtest.h>

#include "config/configuration.hpp"
#include "config/mapping_text.hpp"
#include "support/plant_builder.hpp"

namespace cgw::config {
namespace {

using test::mapping_text;
using test::PlantBuilder;

TEST(Rpdo1, is_inactive_without_switches_and_sensors) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().resolve();
    EXPECT_FALSE(configuration.rpdo(1).active);
    EXPECT_FALSE(configuration.switches_object);
    EXPECT_FALSE(configuration.sensor_flags_object);
    EXPECT_EQ(configuration.rpdo(1).direction, Direction::receive);
    EXPECT_EQ(configuration.rpdo(4).number, 4);
}

TEST(Rpdo1, maps_the_switches_alone) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor(827, 1).governor(4827, 3).governor(835, -5).governor(4835, 3).resolve();
    EXPECT_TRUE(configuration.rpdo(1).active);
    EXPECT_EQ(mapping_text(configuration.rpdo(1)), "2003:1");
    EXPECT_FALSE(configuration.sensor_flags_object);
    ASSERT_EQ(configuration.switches.size(), 2U);
    EXPECT_EQ(configuration.switches[0].row->number, 827);
    EXPECT_EQ(configuration.switches[0].bit, 1);
    EXPECT_FALSE(configuration.switches[0].low_active);
    EXPECT_EQ(configuration.switches[1].bit, 5);
    EXPECT_TRUE(configuration.switches[1].low_active);
}

TEST(Rpdo1, maps_the_sensor_flags_behind_dummies_when_there_are_no_switches) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().governor(900, 1).governor(4900, 3).resolve();
    EXPECT_TRUE(configuration.rpdo(1).active);
    EXPECT_EQ(mapping_text(configuration.rpdo(1)), "dummy dummy 2003:2");
    EXPECT_EQ(configuration.rpdo(1).length(), 6);
    EXPECT_TRUE(configuration.switches_object) << "2003h:1 exists whenever 2003h:2 does (D25)";
    EXPECT_TRUE(configuration.sensor_flags_object);
}

TEST(Rpdo1, maps_switches_and_sensor_flags_around_a_dummy) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor(811, 16).governor(4811, 3).governor(900, 1).governor(4900, 3).resolve();
    EXPECT_EQ(mapping_text(configuration.rpdo(1)), "2003:1 dummy 2003:2");
}

TEST(Rpdo1, ignores_switches_that_do_not_come_over_canopen_or_have_no_usable_bit) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal()
                                            .governor(811, 1)
                                            .governor(4811, 1)  // a hardware input
                                            .governor(812, 0)
                                            .governor(4812, 3)  // no bit
                                            .governor(813, 17)
                                            .governor(4813, 3)  // a finding, not a switch
                                            .governor(814, -17)
                                            .governor(4814, 3)
                                            .governor(4815, 3)  // 815 not set at all
                                            .governor(810, 4)
                                            .governor(4810, 3)  // engine stop never (D34)
                                            .resolve();
    EXPECT_TRUE(configuration.switches.empty());
    EXPECT_FALSE(configuration.rpdo(1).active);
}

TEST(SensorRpdos, fill_gaps_with_dummies_and_end_at_the_last_sensor) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor(900, 2).governor(4900, 3).governor(901, 8).governor(4901, 3).resolve();
    EXPECT_EQ(mapping_text(configuration.rpdo(2)), "dummy 2004:2");
    EXPECT_EQ(mapping_text(configuration.rpdo(3)), "dummy dummy dummy 2004:8");
    EXPECT_FALSE(configuration.rpdo(4).active);
    EXPECT_EQ(configuration.highest_channel, 8);
    EXPECT_EQ(configuration.rpdo(2).mapping[1].parameter->number, 900);
}

TEST(SensorRpdos, name_the_lower_sensor_when_two_share_a_channel) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor(905, 12).governor(4905, 3).governor(904, 12).governor(4904, 3).resolve();
    EXPECT_EQ(configuration.sensors.size(), 2U);
    EXPECT_EQ(mapping_text(configuration.rpdo(4)), "dummy dummy dummy 2004:12");
    EXPECT_EQ(configuration.rpdo(4).mapping[3].parameter->number, 904);
}

TEST(SensorRpdos, ignore_hardware_inputs_channel_zero_and_channels_out_of_range) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal()
                                            .governor(900, 1)
                                            .governor(4900, 0)
                                            .governor(901, 0)
                                            .governor(4901, 3)
                                            .governor(902, 13)
                                            .governor(4902, 3)
                                            .governor(903, -1)
                                            .governor(4903, 3)
                                            .resolve();
    EXPECT_TRUE(configuration.sensors.empty());
    EXPECT_EQ(configuration.highest_channel, 0);
    for (int number = 1; number <= 4; ++number) {
        EXPECT_FALSE(configuration.rpdo(number).active) << number;
    }
}

TEST(RpdoMonitoring, has_an_effective_time_also_when_inactive) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().governor(16481, 100).resolve();
    EXPECT_FALSE(configuration.rpdo(2).active);
    EXPECT_EQ(configuration.rpdo(2).time.effective_us, 93750U);
    EXPECT_EQ(test::decision_text(configuration), "quantised 16481 100 ms to 93750 us");
}

}  // namespace
}  // namespace cgw::config
