#include <gtest/gtest.h>

#include <limits>

#include "config/configuration.hpp"
#include "config/mapping_text.hpp"
#include "support/plant_builder.hpp"

namespace cgw::config {
namespace {

using test::PlantBuilder;

TEST(Resolve, carries_nodes_delays_and_bit_rates_of_both_devices) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().governor(400, 1.5).gateway(400, 0.25).gateway(428, 127).resolve();
    EXPECT_EQ(configuration.governor_node, 1);
    EXPECT_EQ(configuration.gateway_node_in_governor, 2);
    EXPECT_EQ(configuration.gateway_node, 2);
    EXPECT_EQ(configuration.governor_node_in_gateway, 1);
    EXPECT_EQ(configuration.node_id, 1);
    EXPECT_EQ(configuration.partner_node_id, 127);
    EXPECT_EQ(configuration.governor_start_up_delay_ms, 1500U);
    EXPECT_EQ(configuration.gateway_start_up_delay_ms, 250U);
    EXPECT_EQ(configuration.governor_can.bit_rate_kbit, 250);
    EXPECT_EQ(configuration.can1.bit_rate_kbit, 250);
    EXPECT_EQ(configuration.can2.bit_rate_kbit, 125);
    EXPECT_FALSE(configuration.can2.manual);
}

TEST(Resolve, carries_timing_registers_as_typed) {
    PlantBuilder plant;
    plant.minimal().gateway(4426, 1);
    for (std::uint16_t offset = 0; offset < 6; ++offset) {
        plant.gateway(static_cast<std::uint16_t>(420 + offset), offset + 1);
    }
    const Configuration configuration = plant.resolve();
    EXPECT_TRUE(configuration.can2.manual);
    EXPECT_FALSE(configuration.can1.manual);
    EXPECT_EQ(configuration.can2.prescaler, 1);
    EXPECT_EQ(configuration.can2.sync_jump_width, 2);
    EXPECT_EQ(configuration.can2.sampling_mode, 3);
    EXPECT_EQ(configuration.can2.phase_segment_1, 4);
    EXPECT_EQ(configuration.can2.phase_segment_2, 5);
    EXPECT_EQ(configuration.can2.prop_segment, 6);
}

TEST(Resolve, counts_heartbeats_in_gateway_cycles) {
    PlantBuilder plant;
    const Configuration configuration =
        plant.minimal().gateway(428, 127).gateway(429, 1000).gateway(430, 100).resolve();
    EXPECT_EQ(configuration.heartbeat_producer.effective_us, 992000U);
    EXPECT_EQ(configuration.heartbeat_consumer.effective_us, 96000U);
    EXPECT_EQ(test::decision_text(configuration),
              "quantised 429 1000 ms to 992000 us; quantised 430 100 ms to 96000 us");
    EXPECT_EQ(configuration.decisions[0].device, parameter::Device::gateway);
}

TEST(Resolve, monitors_nobody_without_a_partner) {
    PlantBuilder plant;
    const Configuration configuration = plant.minimal().gateway(430, 100).resolve();
    EXPECT_EQ(configuration.heartbeat_consumer.asked_ms, 0U);
    EXPECT_EQ(configuration.heartbeat_consumer.effective_us, 0U);
    EXPECT_TRUE(configuration.decisions.empty());
}

TEST(Resolve, uses_the_main_cycle_of_the_governor) {
    PlantBuilder plant;
    plant.minimal().governor(16460, 100).settings().main_cycle_us = 10000;
    const Configuration configuration = plant.resolve();
    EXPECT_EQ(configuration.tpdo(4).time.cycles, 10U);
    EXPECT_TRUE(configuration.decisions.empty());
}

TEST(Resolve, gives_an_empty_configuration_for_empty_settings) {
    PlantBuilder plant;
    const Configuration configuration = plant.resolve();
    for (int number = 1; number <= 16; ++number) {
        EXPECT_FALSE(configuration.tpdo(number).active) << number;
        EXPECT_EQ(configuration.tpdo(number).number, number);
    }
    EXPECT_TRUE(configuration.decisions.empty());
    EXPECT_EQ(configuration.node_id, 0);
}

TEST(Resolve, takes_values_that_a_parameter_cannot_hold_as_not_set) {
    const double nonsense[] = {-1,
                               -1e300,
                               1e300,
                               70000.0,
                               0.5,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()};
    for (const double value : nonsense) {
        SCOPED_TRACE(value);
        PlantBuilder plant;
        for (const int number :
             {400, 401, 403, 416, 4416, 811, 4811, 900, 4900, 14401, 16400, 16460, 16480}) {
            plant.governor(static_cast<std::uint16_t>(number), value);
        }
        for (const int number : {400, 401, 402, 416, 410, 426, 427, 428, 429, 430, 4426, 16404}) {
            plant.gateway(static_cast<std::uint16_t>(number), value);
        }
        plant.settings().main_cycle_us = 0;
        const Configuration configuration = plant.resolve();
        EXPECT_EQ(configuration.node_id, 0);
        EXPECT_EQ(configuration.governor_node, 0);
        EXPECT_EQ(configuration.can2.bit_rate_kbit, 0);
        EXPECT_EQ(configuration.tpdo(4).time.asked_ms, 0U);
        EXPECT_EQ(configuration.tpdo(5).cob_id, 0);
        EXPECT_EQ(configuration.heartbeat_producer.asked_ms, 0U);
        EXPECT_TRUE(configuration.switches.empty());
        EXPECT_TRUE(configuration.sensors.empty());
        EXPECT_FALSE(configuration.send_errors);
        EXPECT_TRUE(configuration.decisions.empty());
    }
}

TEST(Resolve, takes_the_usual_main_cycle_when_none_is_known) {
    PlantBuilder plant;
    plant.minimal().governor(16460, 1000).settings().main_cycle_us = 0;
    EXPECT_EQ(plant.resolve().tpdo(4).time.cycles, 64U);
}

}  // namespace
}  // namespace cgw::config
