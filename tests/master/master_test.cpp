#include "master/master.hpp"

#include "support/recording_port.hpp"

namespace cgw::master {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;
using test::make_frame;

struct Heard final : Listener {
    void boot_up(std::uint8_t node_id, canopen::Time now) override { boot_ups.emplace_back(node_id, now); }
    void heartbeat(std::uint8_t node_id, NmtState state, canopen::Time) override {
        heartbeats.emplace_back(node_id, state);
    }
    void process_data(const frame::Frame& frame, canopen::Time) override { data.push_back(frame); }

    std::vector<std::pair<std::uint8_t, canopen::Time>> boot_ups;
    std::vector<std::pair<std::uint8_t, NmtState>> heartbeats;
    std::vector<frame::Frame> data;
};

class MasterTest : public testing::Test {
  protected:
    test::RecordingPort port_;
    Heard heard_;
    Master master_{port_, heard_, 5, 1000};
};

TEST_F(MasterTest, sends_nmt_commands) {
    EXPECT_TRUE(master_.command(NmtCommand::start, 5));
    EXPECT_TRUE(master_.command(NmtCommand::reset_node, canopen::all_nodes));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0, {0x01, 5}), make_frame(0, {0x81, 0})}));
}

TEST_F(MasterTest, says_so_when_the_port_takes_nothing) {
    port_.room = 0;
    EXPECT_FALSE(master_.command(NmtCommand::start, 5));
    EXPECT_FALSE(master_.send_process_data(0x205, std::array<std::uint8_t, 2>{1, 2}));
}

TEST_F(MasterTest, sends_process_data_of_at_most_eight_bytes) {
    EXPECT_TRUE(master_.send_process_data(0x205, std::array<std::uint8_t, 2>{1, 2}));
    EXPECT_TRUE(master_.send_process_data(0x305, std::array<std::uint8_t, 9>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(port_.take(),
              (std::vector{make_frame(0x205, {1, 2}), make_frame(0x305, {1, 2, 3, 4, 5, 6, 7, 8})}));
}

TEST_F(MasterTest, hears_boot_up_and_heartbeats_of_every_node) {
    master_.receive(make_frame(0x705, {0x00}), 77);
    master_.receive(make_frame(0x706, {0x05}), 78);
    master_.receive(make_frame(0x77F, {0x7F}), 79);
    ASSERT_EQ(heard_.boot_ups.size(), 1U);
    EXPECT_EQ(heard_.boot_ups[0], (std::pair<std::uint8_t, canopen::Time>{5, 77}));
    ASSERT_EQ(heard_.heartbeats.size(), 2U);
    EXPECT_EQ(heard_.heartbeats[0], (std::pair<std::uint8_t, NmtState>{6, NmtState::operational}));
    EXPECT_EQ(heard_.heartbeats[1], (std::pair<std::uint8_t, NmtState>{127, NmtState::pre_operational}));
}

TEST_F(MasterTest, ignores_what_is_no_heartbeat) {
    master_.receive(make_frame(0x705, {0x09}), 1);
    master_.receive(make_frame(0x705, {0x05, 0x00}), 1);
    master_.receive(make_frame(0x700, {0x05}), 1);
    frame::Frame frame = make_frame(0x705, {0x05});
    frame.remote = true;
    master_.receive(frame, 1);
    EXPECT_TRUE(heard_.heartbeats.empty());
    EXPECT_TRUE(heard_.boot_ups.empty());
}

TEST_F(MasterTest, passes_on_subscribed_process_data_only) {
    ASSERT_TRUE(master_.subscribe(0x185));
    master_.receive(make_frame(0x185, {1}), 1);
    master_.receive(make_frame(0x285, {2}), 1);
    EXPECT_EQ(heard_.data, (std::vector{make_frame(0x185, {1})}));
}

TEST_F(MasterTest, refuses_more_subscriptions_than_it_has_room_for) {
    for (std::size_t i = 0; i < Master::maximum_subscriptions; ++i) {
        EXPECT_TRUE(master_.subscribe(static_cast<std::uint16_t>(0x181 + i)));
    }
    EXPECT_FALSE(master_.subscribe(0x300));
}

TEST_F(MasterTest, runs_an_sdo_transfer) {
    ASSERT_TRUE(master_.sdo().upload({0x1000, 0}));
    EXPECT_TRUE(master_.pending());
    EXPECT_EQ(master_.poll(0), 1000U);
    master_.receive(make_frame(0x585, {0x43, 0x00, 0x10, 0, 9, 0, 0, 0}), 10);
    EXPECT_EQ(master_.sdo().status(), canopen::SdoClient::Status::done);
    EXPECT_EQ(master_.sdo().value(), 9U);
}

}  // namespace
}  // namespace cgw::master
