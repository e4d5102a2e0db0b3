#include <gtest/gtest.h>

#include "check/findings_text.hpp"

namespace cgw::check {
namespace {

using parameter::Device;
using test::errors_of;
using test::PlantBuilder;

TEST(Partner, must_not_be_the_gateway_itself_even_when_it_is_not_monitored) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(428, 1)),
              "20:8 E0203 node-id-duplicate: 428 CanOpenPartnerNodeID and 427 CanOpenMyNodeID are both 1; "
              "the partner "
              "is another node (manual 7.3)\n"
              "  see 18:8: the gateway's 427 CanOpenMyNodeID is 1 here\n");
}

TEST(Partner, is_nobody_when_0) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(428, 0)), "");
}

TEST(ListedNodes, do_not_include_the_gateway) {
    PlantBuilder plant;
    EXPECT_EQ(
        errors_of(plant.minimal().network_node(9).network_node(1)),
        "18:8 E0204 node-id-listed: 427 CanOpenMyNodeID is 1, but [network] lists node 1 as another node "
        "(manual "
        "7.2.2)\n"
        "  see 21:8: node 1 is listed here\n"
        "  help: give the gateway a free node id, or take it out of nodes if it is the gateway itself\n");
}

TEST(ListedNodes, may_include_the_partner) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(428, 9).network_node(9)), "");
}

TEST(ListedNodes, add_nothing_when_the_gateway_has_its_partners_node_id) {
    PlantBuilder plant;
    const std::string text = errors_of(plant.minimal().gateway(428, 9).gateway(427, 9).network_node(9));
    EXPECT_EQ(text.find("E0204"), std::string::npos) << text;
    EXPECT_NE(text.find("E0203"), std::string::npos) << text;
}

TEST(HeartbeatPartner, must_be_named_when_it_is_monitored) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(430, 100)),
              "20:8 E0208 heartbeat-partner-missing: 430 CanOpHeartBeatRxTime is 100 ms, but 428 "
              "CanOpenPartnerNodeID "
              "names no node to monitor (manual 7.2.3)\n"
              "  help: write the partner's node id as 428, or 430 = 0 to monitor nobody\n");
}

TEST(HeartbeatPartner, must_not_be_0_when_it_is_monitored) {
    PlantBuilder plant;
    const std::string text = errors_of(plant.minimal().gateway(430, 100).gateway(428, 0));
    EXPECT_NE(text.find("E0208"), std::string::npos) << text;
    EXPECT_NE(text.find("see 21:8: the gateway's 428 CanOpenPartnerNodeID is 0 here"), std::string::npos)
        << text;
}

TEST(HeartbeatPartner, is_not_missed_when_its_value_is_refused_already) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(430, 100).rejected(Device::gateway, 428)), "");
    EXPECT_EQ(errors_of(plant.gateway(428, 128)), "");
}

TEST(HeartbeatPartner, is_not_needed_when_nothing_is_monitored) {
    PlantBuilder plant;
    EXPECT_EQ(errors_of(plant.minimal().gateway(430, 0)), "");
}

}  // namespace
}  // namespace cgw::check
