// The master and its network: commands that wait, nodes that come and go, SYNC, emergencies.
#include "master/master.hpp"

#include "support/recording_port.hpp"

namespace cgw::master {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;
using canopen::Time;
using test::make_frame;
using test::RecordingPort;

struct Heard final : Listener {
    void boot_up(std::uint8_t, Time) override {}
    void heartbeat(std::uint8_t, NmtState, Time) override {}
    void process_data(const frame::Frame&, Time) override {}
    void emergency(const canopen::ReceivedEmergency& emergency, Time) override {
        emergencies.emplace_back(emergency.node_id, emergency.emergency.code);
    }
    void lost(std::uint8_t node_id, Time now) override { losses.emplace_back(node_id, now); }

    std::vector<std::pair<int, int>> emergencies;
    std::vector<std::pair<int, Time>> losses;
};

class NetworkTest : public testing::Test {
  protected:
    void beat(std::uint8_t node_id, std::uint8_t state, Time now) {
        master_.receive(make_frame(0x700U + node_id, {state}), now);
    }
    RecordingPort port_;
    Heard heard_;
    Master master_{port_, heard_, 5, 1000};
};

TEST_F(NetworkTest, sends_queued_commands_in_order_and_each_once) {
    master_.queue(NmtCommand::reset_node, 5);
    master_.queue(NmtCommand::start, 5);
    master_.queue(NmtCommand::start, canopen::all_nodes);
    EXPECT_TRUE(master_.pending());
    master_.poll(0);
    master_.poll(1);
    EXPECT_FALSE(master_.pending());
    EXPECT_EQ(port_.take(),
              (std::vector{make_frame(0, {0x81, 5}), make_frame(0, {0x01, 5}), make_frame(0, {0x01, 0})}));
}

TEST_F(NetworkTest, keeps_commands_that_the_port_does_not_take) {
    port_.room = 0;
    master_.queue(NmtCommand::start, 1);
    master_.queue(NmtCommand::stop, 1);
    master_.poll(0);
    port_.room = 1;
    master_.poll(1);
    EXPECT_TRUE(master_.pending());
    master_.queue(NmtCommand::start, 2);
    port_.room = RecordingPort::unlimited;
    master_.poll(2);
    EXPECT_EQ(port_.take(),
              (std::vector{make_frame(0, {0x01, 1}), make_frame(0, {0x02, 1}), make_frame(0, {0x01, 2})}));
}

TEST_F(NetworkTest, refuses_more_commands_than_can_wait) {
    for (std::size_t i = 0; i < CommandQueue::capacity; ++i) {
        EXPECT_TRUE(master_.queue(NmtCommand::start, 1));
    }
    EXPECT_FALSE(master_.queue(NmtCommand::start, 1));
    master_.poll(0);
    EXPECT_EQ(port_.take().size(), CommandQueue::capacity);
    EXPECT_TRUE(master_.queue(NmtCommand::start, 1));
}

TEST_F(NetworkTest, knows_what_each_node_said_last) {
    EXPECT_FALSE(master_.nodes().booted(127));
    beat(127, 0x00, 0);
    EXPECT_TRUE(master_.nodes().booted(127));
    EXPECT_FALSE(master_.nodes().heard(127));
    beat(127, 0x7F, 1);
    beat(1, 0x05, 2);
    EXPECT_TRUE(master_.nodes().heard(127));
    EXPECT_EQ(master_.nodes().state(127), NmtState::pre_operational);
    EXPECT_EQ(master_.nodes().state(1), NmtState::operational);
    EXPECT_FALSE(master_.nodes().booted(1));  // it ran before
    EXPECT_FALSE(master_.nodes().heard(2));
}

TEST_F(NetworkTest, loses_a_watched_node_once) {
    master_.nodes().watch(5, 100);
    EXPECT_EQ(master_.poll(10'000), canopen::never);  // no heartbeat yet
    beat(5, 0x05, 10'000);
    beat(6, 0x05, 10'000);  // nobody watches it
    EXPECT_EQ(master_.poll(10'000), 10'101U);
    beat(5, 0x05, 10'090);
    EXPECT_EQ(master_.poll(10'101), 10'191U);
    EXPECT_TRUE(heard_.losses.empty());
    master_.poll(10'191);
    master_.poll(20'000);
    EXPECT_EQ(heard_.losses, (std::vector<std::pair<int, Time>>{{5, 10'191}}));
    EXPECT_TRUE(master_.nodes().lost(5));
    beat(5, 0x05, 30'000);
    EXPECT_FALSE(master_.nodes().lost(5));
}

TEST_F(NetworkTest, loses_several_nodes_at_once) {
    for (const std::uint8_t node_id : {std::uint8_t{1}, std::uint8_t{64}, std::uint8_t{127}}) {
        master_.nodes().watch(node_id, 100);
        beat(node_id, 0x05, 0);
    }
    master_.poll(101);
    EXPECT_EQ(heard_.losses, (std::vector<std::pair<int, Time>>{{1, 101}, {64, 101}, {127, 101}}));
}

TEST_F(NetworkTest, produces_sync) {
    master_.produce_sync(canopen::SyncProducer(0x80, 1000), 500);
    EXPECT_EQ(master_.poll(500), 1500U);
    port_.room = 0;
    master_.poll(1500);
    EXPECT_TRUE(master_.pending());
    port_.room = RecordingPort::unlimited;
    EXPECT_EQ(master_.poll(1600), 2500U);
    EXPECT_EQ(port_.take(), (std::vector<frame::Frame>(2, make_frame(0x80, {}))));
    master_.produce_sync({}, 2000);
    EXPECT_EQ(master_.poll(9000), canopen::never);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(NetworkTest, hears_emergencies_of_every_node) {
    master_.receive(make_frame(0x085, {0x10, 0x10, 1, 0, 0, 0, 0, 0}), 0);
    master_.receive(make_frame(0x0FF, {0x00, 0x00, 0, 0, 0, 0, 0, 0}), 0);
    master_.receive(make_frame(0x080, {}), 0);
    EXPECT_EQ(heard_.emergencies, (std::vector<std::pair<int, int>>{{5, 0x1010}, {127, 0}}));
}

}  // namespace
}  // namespace cgw::master
