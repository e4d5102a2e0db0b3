// What a slave watches in Operational: its receive PDO (50 ms) and the heartbeat of node 9 (200 ms).
#include "canopen/slave_test.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using Kind = Slave::Event::Kind;

class SlaveMonitoring : public test::SlaveTest {
  protected:
    void start() {
        boot_up();
        command(NmtCommand::start);
    }
    void rpdo(Time now, std::initializer_list<std::uint8_t> data = {1, 2, 3, 4}) {
        slave_.receive(make_frame(0x205, data), now);
    }
    bool rpdo_late(Time now) {
        slave_.poll(now);
        return monitors_[0].tripped();
    }
    bool heartbeat_lost(Time now) {
        slave_.poll(now);
        return slave_.heartbeat_monitor().tripped();
    }
};

TEST_F(SlaveMonitoring, misses_nothing_before_operational) {
    boot_up();
    EXPECT_FALSE(rpdo_late(10'000'000));
    EXPECT_FALSE(heartbeat_lost(10'000'000));
}

TEST_F(SlaveMonitoring, says_when_it_will_miss_something) {
    start();
    EXPECT_EQ(slave_.poll(0), 50'001U);  // before the heartbeat at 100 ms
    EXPECT_FALSE(rpdo_late(50'000));
    EXPECT_TRUE(rpdo_late(50'001));
}

TEST_F(SlaveMonitoring, is_fed_by_each_receive_pdo_that_is_long_enough) {
    start();
    rpdo(50'000);
    EXPECT_FALSE(rpdo_late(100'000));
    rpdo(90'000, {1, 2, 3});  // D28: not processed
    EXPECT_TRUE(rpdo_late(100'001));
}

TEST_F(SlaveMonitoring, is_fed_by_every_state_of_the_partner) {
    start();
    Time now = 0;
    for (const NmtState state :
         {NmtState::initialising, NmtState::stopped, NmtState::operational, NmtState::pre_operational}) {
        now += 200'000;
        slave_.receive(heartbeat_frame(9, state), now);
        EXPECT_FALSE(heartbeat_lost(now + 199'999));
    }
    EXPECT_TRUE(heartbeat_lost(now + 200'001));
}

TEST_F(SlaveMonitoring, is_not_fed_by_what_is_no_heartbeat_of_the_partner) {
    start();
    slave_.receive(make_frame(0x708, {0x05}), 100'000);
    slave_.receive(make_frame(0x709, {0x06}), 100'000);
    slave_.receive(make_frame(0x709, {0x05, 0}), 100'000);
    frame::Frame extended = make_frame(0x709, {0x05});
    extended.extended = true;
    slave_.receive(extended, 100'000);
    EXPECT_TRUE(heartbeat_lost(200'001));
}

TEST_F(SlaveMonitoring, forgets_what_it_missed_when_operational_ends) {
    start();
    EXPECT_TRUE(rpdo_late(1'000'000));
    EXPECT_TRUE(heartbeat_lost(1'000'000));
    command(NmtCommand::enter_pre_operational);
    EXPECT_FALSE(rpdo_late(2'000'000));
    EXPECT_FALSE(heartbeat_lost(2'000'000));
}

TEST_F(SlaveMonitoring, begins_anew_with_each_entry) {
    start();
    command(NmtCommand::stop);
    now_ = 5'000'000;
    command(NmtCommand::start);
    EXPECT_FALSE(rpdo_late(5'050'000));
    EXPECT_TRUE(rpdo_late(5'050'001));
}

TEST_F(SlaveMonitoring, is_not_begun_anew_by_a_second_start) {
    start();
    now_ = 40'000;
    EXPECT_EQ(command(NmtCommand::start), Kind::none);
    EXPECT_TRUE(rpdo_late(50'001));
}

TEST_F(SlaveMonitoring, tells_of_requests_that_find_no_room_for_their_answer) {
    start();
    port_.room = 0;
    const frame::Frame request = make_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0});
    for (std::size_t i = 0; i < SdoServer::capacity; ++i) {
        EXPECT_EQ(slave_.receive(request, 0).kind, Kind::none);
    }
    EXPECT_EQ(slave_.receive(request, 0).kind, Kind::sdo_overflow);
}

TEST_F(SlaveMonitoring, announces_itself_with_a_heartbeat_out_of_turn) {
    start();
    slave_.announce(30'000);
    slave_.poll(30'000);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x705, {0x05})}));
}

}  // namespace
}  // namespace cgw::canopen
