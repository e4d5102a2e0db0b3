#include <gtest/gtest.h>

#include "check/findings_text.hpp"

namespace cgw::check {
namespace {

using parameter::Device;
using test::errors_of;
using test::PlantBuilder;

TEST(HzmNodes, are_fine_when_each_device_knows_the_other) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal()), "");
}

TEST(HzmNodes, must_agree_on_the_governor) {
    PlantBuilder plant;
    plant.minimal().gateway(402, 3);
    EXPECT_EQ(errors_of(plant),
              "10:8 E0201 hzm-node-mismatch: the governor's 401 CanMyNodeNumber is 1, but the gateway's 402 "
              "CanDCNodeNumber is 3 (manual 7.1.1)\n"
              "  see 20:8: the gateway's 402 CanDCNodeNumber is 3 here\n"
              "  help: if the governor is node 1, write 402 = 1 in [gateway.parameters]\n");
}

TEST(HzmNodes, must_agree_on_the_gateway) {
    PlantBuilder plant;
    plant.minimal().governor(403, 5);
    EXPECT_EQ(errors_of(plant),
              "20:8 E0201 hzm-node-mismatch: the governor's 403 CanCMNodeNumber is 5, but the gateway's 401 "
              "CanMyNodeNumber is 2 (manual 7.1.1)\n"
              "  see 14:8: the gateway's 401 CanMyNodeNumber is 2 here\n"
              "  help: if the gateway is node 2, write 403 = 2 in [governor.parameters]\n");
}

TEST(HzmNodes, are_one_finding_when_the_gateways_two_numbers_are_exchanged) {
    PlantBuilder plant;
    plant.minimal().gateway(401, 1).gateway(402, 2);
    EXPECT_EQ(errors_of(plant),
              "20:8 E0201 hzm-node-mismatch: the gateway's 401 CanMyNodeNumber is 1 and its 402 "
              "CanDCNodeNumber is 2, "
              "but the governor is node 1 and knows the gateway as node 2 (manual 7.1.1)\n"
              "  see 10:8: the governor's 401 CanMyNodeNumber is 1 here\n"
              "  see 11:8: the governor's 403 CanCMNodeNumber is 2 here\n"
              "  help: exchange the two: 401 = 2 and 402 = 1 in [gateway.parameters]\n");
}

TEST(HzmNodes, stay_silent_when_a_number_is_absent_or_out_of_range) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().without(Device::gateway, 402)), "");
    EXPECT_EQ(errors_of(plant.gateway(402, 32)), "");
    EXPECT_EQ(errors_of(plant.gateway(402, 1).without(Device::governor, 403)), "");
}

TEST(HzmBitRates, must_be_the_same) {
    PlantBuilder plant;
    plant.minimal().gateway(416, 125);
    EXPECT_EQ(errors_of(plant),
              "12:8 E0202 hzm-bit-rate-mismatch: the governor's 416 CanBaudrate is 250 kbit/s, but the "
              "gateway's 416 "
              "HzmCanBaudrate is 125 kbit/s; both share the HEINZMANN CAN bus (manual 7.1.1)\n"
              "  see 20:8: the gateway's 416 HzmCanBaudrate is 125 kbit/s here\n");
}

TEST(HzmBitRates, are_not_compared_when_either_side_is_set_by_hand) {
    PlantBuilder governor;
    EXPECT_EQ(errors_of(governor.minimal().gateway(416, 125).governor(4416, 1)), "");
    PlantBuilder gateway;
    EXPECT_EQ(errors_of(gateway.minimal().gateway(416, 125).gateway(4416, 1)), "");
    PlantBuilder unclear;
    EXPECT_EQ(errors_of(unclear.minimal().gateway(416, 125).rejected(Device::gateway, 4416)), "");
}

TEST(HzmBitRates, may_equal_the_canopen_bit_rate) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(426, 250)), "") << "D5";
}

TEST(Communication, must_be_on_in_the_governor) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().governor(4406, 0)),
              "20:8 E0215 communication-off: 4406 CanCommCMOn is 0: the governor does not talk to the "
              "gateway (manual "
              "7.1.1)\n"
              "  help: write 4406 = 1 in [governor.parameters]\n");
}

TEST(Communication, is_off_when_it_is_not_set_and_is_missed_at_the_header) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().without(Device::gateway, 4400)),
              "2:8 E0215 communication-off: 4400 HzmCanCommDCon is not set: the gateway does not talk to the "
              "governor "
              "(manual 7.2.1)\n"
              "  help: write 4400 = 1 in [gateway.parameters]\n");
}

TEST(Communication, stays_silent_about_a_value_that_is_refused_already_and_about_a_missing_table) {
    PlantBuilder refused;
    EXPECT_EQ(errors_of(refused.minimal().rejected(Device::gateway, 4400)), "");
    EXPECT_EQ(errors_of(refused.minimal().gateway(4400, 2)), "");
    PlantBuilder headless;
    headless.minimal().without(Device::governor, 4406).settings().governor_table = {};
    EXPECT_EQ(errors_of(headless), "");
}

}  // namespace
}  // namespace cgw::check
