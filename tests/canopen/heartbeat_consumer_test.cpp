// Nodes 3 (watched, 100 us), 9 (watched, 300 us) and 7 (only followed).
#include "canopen/heartbeat_consumer.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;

class HeartbeatConsumerTest : public testing::Test {
  protected:
    void beat(std::uint8_t node, Time now, std::uint8_t state = 0x05) {
        consumer_.receive(make_frame(0x700U + node, {state}), now);
    }
    std::array<HeartbeatConsumer::Node, 3> nodes_{
        {{.node_id = 3, .period = 100}, {.node_id = 9, .period = 300}, {.node_id = 7}}};
    HeartbeatConsumer consumer_{nodes_};
};

TEST_F(HeartbeatConsumerTest, misses_nobody_before_the_first_heartbeat) {
    EXPECT_EQ(consumer_.deadline(), never);
    EXPECT_FALSE(consumer_.expire(1'000'000));
    EXPECT_FALSE(nodes_[0].heard || nodes_[0].lost);
}

TEST_F(HeartbeatConsumerTest, misses_a_node_when_its_period_has_passed) {
    beat(3, 1000);
    EXPECT_EQ(consumer_.deadline(), 1101U);
    EXPECT_FALSE(consumer_.expire(1100));
    EXPECT_EQ(consumer_.expire(1101), std::size_t{0});
    EXPECT_TRUE(nodes_[0].lost);
    EXPECT_FALSE(consumer_.expire(1101));
    EXPECT_EQ(consumer_.deadline(), never);
}

TEST_F(HeartbeatConsumerTest, finds_a_node_again_with_its_next_heartbeat) {
    beat(3, 0);
    EXPECT_TRUE(consumer_.expire(1000));
    beat(3, 2000, 0x7F);
    EXPECT_FALSE(nodes_[0].lost);
    EXPECT_EQ(nodes_[0].state, NmtState::pre_operational);
    EXPECT_EQ(consumer_.expire(2101), std::size_t{0});
}

TEST_F(HeartbeatConsumerTest, tells_of_all_that_went_missing_at_once) {
    beat(3, 0);
    beat(9, 0);
    beat(7, 0);
    EXPECT_EQ(consumer_.expire(1000), std::size_t{0});
    EXPECT_EQ(consumer_.expire(1000), std::size_t{1});
    EXPECT_FALSE(consumer_.expire(1000));
    EXPECT_EQ(nodes_[2].state, NmtState::operational);
    EXPECT_FALSE(nodes_[2].lost);
}

TEST_F(HeartbeatConsumerTest, is_silent_between_a_boot_up_and_the_next_heartbeat) {
    beat(3, 0);
    beat(3, 50, 0x00);
    EXPECT_FALSE(nodes_[0].heard);
    EXPECT_FALSE(consumer_.expire(1000));
    beat(3, 1000);
    EXPECT_EQ(consumer_.expire(1101), std::size_t{0});
}

TEST_F(HeartbeatConsumerTest, hears_no_other_node_and_no_malformed_heartbeat) {
    beat(4, 0);
    beat(3, 0, 0x06);
    consumer_.receive(make_frame(0x703, {0x05, 0x00}), 0);
    consumer_.receive(make_frame(0x700, {0x05}), 0);
    frame::Frame remote = make_frame(0x703, {0x05});
    remote.remote = true;
    EXPECT_FALSE(consumer_.receive(remote, 0));
    EXPECT_EQ(consumer_.deadline(), never);
}

}  // namespace
}  // namespace cgw::canopen
