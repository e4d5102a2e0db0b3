// The parameterisation examples of the manual's chapter 7, with what the manual says comes of them.
#include <gtest/gtest.h>

#include "config/configuration.hpp"
#include "config/mapping_text.hpp"
#include "support/plant_builder.hpp"

namespace cgw::config {
namespace {

using test::decision_text;
using test::mapping_text;
using test::PlantBuilder;

class ManualExample : public testing::Test {
  protected:
    ManualExample() {
        plant.governor(400, 1).governor(401, 1).governor(403, 1).governor(416, 250).governor(4406, 1);
        plant.governor(14401, 1).governor(14402, 0);
        plant.governor_list(16400, {2000, 2031, 2300, 2330, 0, 0})
            .governor_list(16446, {0, 0, 2905, 2908, 2917, 0});
        plant.governor_list(16460, {16, 0, 200, 0, 0, 0, 0, 0, 0, 0, 0, 0, 100});
        plant.governor(827, 1).governor(835, -5).governor(4827, 3).governor(4835, 3);
        plant.governor(900, 1).governor(901, 2).governor(906, 7).governor(917, 12);
        plant.governor(4900, 3).governor(4901, 3).governor(4906, 3).governor(4917, 3);
        plant.governor_list(16480, {0, 100, 200, 1000});
        plant.gateway(400, 1).gateway(401, 1).gateway(402, 1).gateway(416, 250).gateway(4400, 1).gateway(4416,
                                                                                                         0);
        plant.gateway(427, 1).gateway(426, 125).gateway(4426, 0);
        plant.gateway(428, 127).gateway(429, 1000).gateway(430, 100);
        plant.gateway(16404, 0x282).gateway(16407, 0x382).gateway(16411, 0x3).gateway(16415, 0x57F);
        configuration = plant.resolve();
    }

    PlantBuilder plant;
    Configuration configuration;
};

TEST_F(ManualExample, sends_what_7_1_2_says) {
    EXPECT_EQ(mapping_text(configuration.tpdo(4)), "2001:1 2001:2 2001:3 2001:4");
    EXPECT_EQ(configuration.tpdo(4).length(), 8);
    EXPECT_EQ(mapping_text(configuration.tpdo(16)), "2001:5 2001:6 2001:7");
    EXPECT_EQ(configuration.tpdo(16).length(), 6);
    EXPECT_FALSE(configuration.tpdo(3).active);
    for (int number = 5; number <= 15; ++number) {
        EXPECT_FALSE(configuration.tpdo(number).active) << number;
    }
}

TEST_F(ManualExample, sends_as_often_as_7_1_3_says) {
    EXPECT_EQ(configuration.tpdo(4).time.effective_us, 15625U);
    EXPECT_EQ(configuration.tpdo(6).time.effective_us, 187500U);
    EXPECT_EQ(configuration.tpdo(16).time.effective_us, 93750U);
}

TEST_F(ManualExample, receives_what_7_1_4_says) {
    EXPECT_EQ(mapping_text(configuration.rpdo(1)), "2003:1 dummy 2003:2");
    EXPECT_EQ(mapping_text(configuration.rpdo(2)), "2004:1 2004:2");
    EXPECT_EQ(mapping_text(configuration.rpdo(3)), "dummy dummy 2004:7");
    EXPECT_EQ(mapping_text(configuration.rpdo(4)), "dummy dummy dummy 2004:12");
    EXPECT_EQ(configuration.highest_channel, 12);
}

TEST_F(ManualExample, monitors_as_7_1_5_and_7_2_3_say) {
    EXPECT_EQ(configuration.rpdo(1).time.cycles, 0U);
    EXPECT_EQ(configuration.rpdo(2).time.cycles, 6U);
    EXPECT_EQ(configuration.rpdo(2).time.effective_us, 93750U);
    EXPECT_EQ(configuration.rpdo(3).time.cycles, 12U);
    EXPECT_EQ(configuration.rpdo(3).time.effective_us, 187500U);
    EXPECT_EQ(configuration.rpdo(4).time.cycles, 64U);
    EXPECT_EQ(configuration.rpdo(4).time.effective_us, 1000000U);
    EXPECT_EQ(configuration.heartbeat_producer.effective_us, 992000U);
    EXPECT_EQ(configuration.heartbeat_consumer.effective_us, 96000U);
}

TEST_F(ManualExample, uses_the_identifiers_of_7_2_4) {
    EXPECT_EQ(configuration.tpdo(4).cob_id, 0x481);
    EXPECT_EQ(configuration.tpdo(5).cob_id, 0x282);
    EXPECT_EQ(configuration.tpdo(8).cob_id, 0x382);
    EXPECT_EQ(configuration.tpdo(12).cob_id, 0x003);
    EXPECT_EQ(configuration.tpdo(16).cob_id, 0x57F);
}

TEST_F(ManualExample, decides_about_times_only) {
    EXPECT_EQ(decision_text(configuration),
              "quantised 16460 16 ms to 15625 us; quantised 16462 200 ms to 187500 us; "
              "quantised 16472 100 ms to 93750 us; quantised 16481 100 ms to 93750 us; "
              "quantised 16482 200 ms to 187500 us; quantised 429 1000 ms to 992000 us; "
              "quantised 430 100 ms to 96000 us");
}

}  // namespace
}  // namespace cgw::config
