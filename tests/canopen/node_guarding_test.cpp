#include "canopen/node_guarding.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;
using Heard = NodeGuard::Heard;

frame::Frame question(std::uint32_t id = 0x705) {
    frame::Frame frame = make_frame(id, {0});
    frame.remote = true;
    return frame;
}

// Node 5, guard time 100 us, factor 3.
class GuardedNodeTest : public testing::Test {
  protected:
    std::vector<frame::Frame> ask(NmtState state, Time now = 0) {
        EXPECT_TRUE(node_.receive(question(), now));
        node_.send_due(state, port_);
        return port_.take();
    }
    GuardedNode node_{5, 100, 3};
    RecordingPort port_;
};

TEST_F(GuardedNodeTest, answers_with_its_state_and_a_bit_that_toggles) {
    EXPECT_EQ(ask(NmtState::pre_operational), (std::vector{make_frame(0x705, {0x7F})}));
    EXPECT_EQ(ask(NmtState::operational), (std::vector{make_frame(0x705, {0x85})}));
    EXPECT_EQ(ask(NmtState::stopped), (std::vector{make_frame(0x705, {0x04})}));
    EXPECT_EQ(ask(NmtState::stopped), (std::vector{make_frame(0x705, {0x84})}));
}

TEST_F(GuardedNodeTest, begins_with_toggle_bit_0_after_each_boot_up) {
    ask(NmtState::operational);
    node_.boot_up();
    EXPECT_EQ(ask(NmtState::pre_operational), (std::vector{make_frame(0x705, {0x7F})}));
}

TEST_F(GuardedNodeTest, answers_nothing_else) {
    EXPECT_FALSE(node_.receive(question(0x706), 0));
    EXPECT_FALSE(node_.receive(make_frame(0x705, {0}), 0));
    frame::Frame extended = question();
    extended.extended = true;
    EXPECT_FALSE(node_.receive(extended, 0));
    EXPECT_TRUE(node_.send_due(NmtState::operational, port_));
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(GuardedNodeTest, keeps_an_answer_with_the_state_of_the_moment_it_leaves) {
    port_.room = 0;
    ask(NmtState::operational);
    EXPECT_TRUE(node_.pending());
    EXPECT_FALSE(node_.send_due(NmtState::operational, port_));
    port_.room = RecordingPort::unlimited;
    EXPECT_TRUE(node_.send_due(NmtState::stopped, port_));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x04})}));
    EXPECT_EQ(ask(NmtState::stopped), (std::vector{make_frame(0x705, {0x84})}));  // toggled once
}

TEST_F(GuardedNodeTest, misses_its_master_a_life_time_after_the_last_question_only) {
    EXPECT_EQ(node_.poll(1'000'000), never);  // not asked yet
    EXPECT_FALSE(node_.master_lost());
    ask(NmtState::operational, 1'000'000);
    EXPECT_EQ(node_.poll(1'000'299), 1'000'300U);
    EXPECT_FALSE(node_.master_lost());
    EXPECT_EQ(node_.poll(1'000'300), never);
    EXPECT_TRUE(node_.master_lost());
    ask(NmtState::operational, 2'000'000);
    EXPECT_FALSE(node_.master_lost());
    node_.poll(3'000'000);
    node_.boot_up();
    EXPECT_FALSE(node_.master_lost());
}

TEST(GuardedNode, never_misses_its_master_without_a_life_time) {
    for (GuardedNode node : {GuardedNode(5, 100, 0), GuardedNode(5, 0, 3)}) {
        EXPECT_TRUE(node.receive(question(), 0));
        EXPECT_EQ(node.poll(1'000'000), never);
        EXPECT_FALSE(node.master_lost());
    }
}

class NodeGuardTest : public testing::Test {
  protected:
    Heard answer(std::uint8_t byte, Time now) { return guard_.receive(make_frame(0x705, {byte}), now); }
    NodeGuard guard_{5, 100, 3};
    RecordingPort port_;
};

TEST_F(NodeGuardTest, asks_in_its_rhythm) {
    EXPECT_EQ(guard_.poll(0, port_), never);
    guard_.start(1000);
    EXPECT_EQ(guard_.poll(1000, port_), 1100U);
    EXPECT_EQ(guard_.poll(1130, port_), 1200U);
    EXPECT_EQ(port_.take(), (std::vector{question(), question()}));
    guard_.stop();
    EXPECT_EQ(guard_.poll(5000, port_), never);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(NodeGuardTest, asks_again_when_the_port_did_not_take_the_question) {
    guard_.start(0);
    port_.room = 0;
    EXPECT_EQ(guard_.poll(0, port_), 300U);
    EXPECT_TRUE(guard_.pending());
    port_.room = RecordingPort::unlimited;
    EXPECT_EQ(guard_.poll(40, port_), 100U);
    EXPECT_FALSE(guard_.pending());
    EXPECT_EQ(port_.take().size(), 1U);
}

TEST_F(NodeGuardTest, follows_the_state_while_the_bit_toggles) {
    guard_.start(0);
    EXPECT_EQ(answer(0x85, 10), Heard::state);  // whatever the first one has
    EXPECT_EQ(guard_.state(), NmtState::operational);
    EXPECT_EQ(answer(0x7F, 110), Heard::state);
    EXPECT_EQ(guard_.state(), NmtState::pre_operational);
    EXPECT_EQ(answer(0x04, 210), Heard::wrong_toggle);
    EXPECT_EQ(guard_.state(), NmtState::pre_operational);
    EXPECT_EQ(answer(0x84, 310), Heard::state);
}

TEST_F(NodeGuardTest, expects_toggle_bit_0_after_a_boot_up) {
    guard_.start(0);
    answer(0x05, 10);
    EXPECT_EQ(answer(0x00, 20), Heard::boot_up);
    EXPECT_EQ(answer(0xFF, 30), Heard::wrong_toggle);
    EXPECT_EQ(answer(0x7F, 40), Heard::state);
}

TEST_F(NodeGuardTest, misses_a_node_that_does_not_answer_for_a_life_time) {
    guard_.start(0);
    guard_.poll(299, port_);
    EXPECT_FALSE(guard_.lost());
    guard_.poll(300, port_);
    EXPECT_TRUE(guard_.lost());
    answer(0x05, 310);
    EXPECT_FALSE(guard_.lost());
    answer(0x05, 400);  // does not toggle, so it does not count
    guard_.poll(610, port_);
    EXPECT_TRUE(guard_.lost());
}

TEST_F(NodeGuardTest, hears_nothing_that_is_no_answer_of_its_node) {
    EXPECT_EQ(answer(0x05, 0), Heard::nothing);  // not started
    guard_.start(0);
    EXPECT_EQ(guard_.receive(question(), 1), Heard::nothing);
    EXPECT_EQ(guard_.receive(make_frame(0x706, {0x05}), 1), Heard::nothing);
    EXPECT_EQ(guard_.receive(make_frame(0x705, {0x05, 0}), 1), Heard::nothing);
    EXPECT_EQ(answer(0x06, 1), Heard::nothing);
}

TEST(NodeGuard, and_guarded_node_understand_each_other) {
    RecordingPort from_master;
    RecordingPort from_node;
    NodeGuard guard(5, 100, 3);
    GuardedNode node(5, 100, 3);
    guard.start(0);
    for (Time now = 0; now < 5000; now += 50) {
        guard.poll(now, from_master);
        for (const frame::Frame& frame : from_master.take()) {
            EXPECT_TRUE(node.receive(frame, now));
        }
        node.poll(now);
        node.send_due(NmtState::operational, from_node);
        for (const frame::Frame& frame : from_node.take()) {
            EXPECT_EQ(guard.receive(frame, now), Heard::state);
        }
        EXPECT_FALSE(guard.lost() || node.master_lost());
    }
    EXPECT_EQ(guard.state(), NmtState::operational);
}

}  // namespace
}  // namespace cgw::canopen
