#include "canopen/nmt.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;

TEST(Nmt, reads_each_command_for_its_node_and_for_all) {
    for (const NmtCommand command : {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                                     NmtCommand::reset_node, NmtCommand::reset_communication}) {
        EXPECT_EQ(nmt_command(nmt_frame(command, 5), 5), command);
        EXPECT_EQ(nmt_command(nmt_frame(command, all_nodes), 5), command);
    }
}

TEST(Nmt, ignores_a_command_for_another_node) {
    EXPECT_EQ(nmt_command(nmt_frame(NmtCommand::start, 6), 5), std::nullopt);
}

TEST(Nmt, ignores_every_length_but_two) {
    EXPECT_EQ(nmt_command(make_frame(0, {0x01}), 5), std::nullopt);
    EXPECT_EQ(nmt_command(make_frame(0, {0x01, 5, 0}), 5), std::nullopt);
    EXPECT_EQ(nmt_command(make_frame(0, {}), 5), std::nullopt);
    EXPECT_EQ(nmt_command(make_frame(0, {0x01, 5, 0, 0, 0, 0, 0, 0}), 5), std::nullopt);
}

TEST(Nmt, ignores_every_unknown_command) {
    int known = 0;
    for (int byte = 0; byte < 256; ++byte) {
        known += nmt_command(make_frame(0, {static_cast<std::uint8_t>(byte), 5}), 5).has_value() ? 1 : 0;
    }
    EXPECT_EQ(known, 5);
}

TEST(Nmt, ignores_remote_and_extended_frames_and_other_identifiers) {
    frame::Frame frame = nmt_frame(NmtCommand::start, 5);
    frame.remote = true;
    EXPECT_EQ(nmt_command(frame, 5), std::nullopt);
    frame = nmt_frame(NmtCommand::start, 5);
    frame.extended = true;
    EXPECT_EQ(nmt_command(frame, 5), std::nullopt);
    EXPECT_EQ(nmt_command(make_frame(1, {0x01, 5}), 5), std::nullopt);
}

TEST(Nmt, builds_the_frames_of_the_manual) {
    EXPECT_EQ(nmt_frame(NmtCommand::reset_communication, 9), make_frame(0x000, {0x82, 9}));
    EXPECT_EQ(heartbeat_frame(9, NmtState::initialising), make_frame(0x709, {0x00}));
    EXPECT_EQ(heartbeat_frame(9, NmtState::pre_operational), make_frame(0x709, {0x7F}));
}

}  // namespace
}  // namespace cgw::canopen
