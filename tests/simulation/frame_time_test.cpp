#include "simulation/frame_time.hpp"

#include "support/recording_port.hpp"

namespace cgw::simulation {
namespace {

using test::make_frame;

frame::Frame filled(std::uint32_t id, std::uint8_t byte) {
    return make_frame(id, std::vector<std::uint8_t>(8, byte));
}

// Reference values from an independent calculation of CRC and stuffing.
TEST(FrameTime, counts_the_bits_of_known_frames) {
    EXPECT_EQ(bits_on_wire(filled(0x555, 0x55)), 112U);
    EXPECT_EQ(bits_on_wire(filled(0x000, 0x00)), 127U);
    EXPECT_EQ(bits_on_wire(filled(0x7FF, 0xFF)), 126U);
    EXPECT_EQ(bits_on_wire(filled(0x785, 0x3C)), 127U);
    EXPECT_EQ(bits_on_wire(make_frame(0x705, {0x00})), 58U);
    EXPECT_EQ(bits_on_wire(make_frame(0x000, {0x01, 0x05})), 70U);
}

TEST(FrameTime, counts_no_data_bits_of_a_remote_frame) {
    frame::Frame frame = make_frame(0x705, {0xAA});
    frame.remote = true;
    EXPECT_EQ(bits_on_wire(frame), 49U);
}

TEST(FrameTime, stays_between_no_stuffing_and_the_worst_case) {
    std::uint32_t noise = 12345;
    for (int round = 0; round < 2000; ++round) {
        frame::Frame frame;
        noise = noise * 1664525 + 1013904223;
        frame.id = noise >> 21;
        frame.length = static_cast<std::uint8_t>((noise >> 8) % 9);
        for (std::uint8_t& byte : frame.data) {
            noise = noise * 1664525 + 1013904223;
            byte = static_cast<std::uint8_t>(noise >> 24);
        }
        EXPECT_GE(bits_on_wire(frame), 47U + 8U * frame.length);
        EXPECT_LE(bits_on_wire(frame), 55U + 10U * frame.length);
    }
}

TEST(FrameTime, counts_twenty_bits_more_for_an_extended_identifier) {
    frame::Frame frame = make_frame(0x0AAAAAAA, {0x55});
    frame.extended = true;
    EXPECT_GE(bits_on_wire(frame), 47U + 20U + 8U);
    EXPECT_LE(bits_on_wire(frame), 80U + 10U);
}

}  // namespace
}  // namespace cgw::simulation
