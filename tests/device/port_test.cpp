// A port that says "not now": nothing is lost, nothing wedges.
#include "device/gateway_test.hpp"

namespace cgw::device {
namespace {

using canopen::NmtCommand;
using test::identifiers;
using test::make_frame;
using test::RecordingPort;

class GatewayPort : public test::GatewayTest {
  protected:
    void block() { port_.room = 0; }
    std::vector<frame::Frame> unblock() {
        port_.room = RecordingPort::unlimited;
        gateway_.poll(now_);
        return port_.take();
    }
};

TEST_F(GatewayPort, keeps_the_boot_up_message) {
    ASSERT_EQ(open(), OpenStatus::ok);
    block();
    command(GovernorCommand::init);
    command(GovernorCommand::pre_operational);
    EXPECT_TRUE(gateway_.pending());
    EXPECT_EQ(unblock(), (std::vector{make_frame(0x705, {0x00})}));
    EXPECT_FALSE(gateway_.pending());
}

TEST_F(GatewayPort, keeps_an_sdo_answer) {
    boot_up();
    block();
    gateway_.receive(canopen::sdo::make_frame(0x605, 0x40, {0x1018, 1}, 0), now_);
    EXPECT_TRUE(gateway_.pending());
    EXPECT_EQ(unblock(), (std::vector{canopen::sdo::make_frame(0x585, 0x43, {0x1018, 1}, 0x161)}));
}

TEST_F(GatewayPort, keeps_a_change_of_state_with_its_newest_data) {
    start();
    cycle();
    block();
    data_.errors[0] = 1;
    cycle();
    data_.errors[0] = 3;
    cycle();
    const std::vector<frame::Frame> sent = unblock();
    EXPECT_EQ(std::count(sent.begin(), sent.end(), make_frame(0x185, {3, 0, 0, 0, 0, 0, 0, 0})), 1);
    EXPECT_EQ(std::count_if(sent.begin(), sent.end(), [](const auto& frame) { return frame.id == 0x185; }),
              1);
    EXPECT_GT(gateway_.slave().transmitter().counters().deferred, 0U);
    EXPECT_GT(gateway_.slave().transmitter().counters().superseded, 0U);
}

TEST_F(GatewayPort, sends_a_change_that_was_undone_while_it_waited) {
    start();
    cycle();
    block();
    data_.errors[0] = 1;
    cycle();
    data_.errors[0] = 0;
    cycle();
    const std::vector<std::uint32_t> sent = identifiers(unblock());
    EXPECT_EQ(std::count(sent.begin(), sent.end(), 0x185U), 1);
}

TEST_F(GatewayPort, catches_up_with_everything_after_a_long_blockade) {
    start();
    block();
    for (int i = 0; i < 500; ++i) {
        data_.errors[0] = static_cast<std::uint16_t>(data_.errors[0] ^ 1U);
        data_.errors[4] = static_cast<std::uint16_t>(i);
        cycle();
        gateway_.poll(now_);
    }
    const std::vector<std::uint32_t> sent = identifiers(unblock());
    EXPECT_EQ(sent.front(), 0x705U);  // the heartbeat that fell due meanwhile, once
    for (const std::uint32_t id : {0x185U, 0x285U, 0x485U, 0x282U}) {
        EXPECT_EQ(std::count(sent.begin(), sent.end(), id), 1) << id;
    }
    EXPECT_EQ(sent.size(), 5U);
    EXPECT_EQ(identifiers(cycle()).front(), 0x485U);  // and the rhythm goes on
}

TEST_F(GatewayPort, loses_nothing_when_there_is_room_for_one_frame_at_a_time) {
    start();
    std::vector<std::uint32_t> sent;
    block();
    data_.errors[0] = 1;
    data_.errors[4] = 1;
    cycle();
    while (gateway_.pending()) {
        port_.room = 1;
        gateway_.poll(now_);
        ASSERT_EQ(port_.sent.size(), 1U);
        sent.push_back(port_.take().front().id);
    }
    std::sort(sent.begin(), sent.end());
    EXPECT_EQ(sent, (std::vector<std::uint32_t>{0x185, 0x282, 0x285, 0x485}));
}

TEST_F(GatewayPort, sends_nothing_late_after_leaving_operational) {
    start();
    block();
    data_.errors[0] = 1;
    cycle();
    nmt(NmtCommand::enter_pre_operational);
    EXPECT_TRUE(unblock().empty());
}

}  // namespace
}  // namespace cgw::device
