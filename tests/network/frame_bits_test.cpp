#include "network/frame_bits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace cgw::network {

TEST(FrameBits, of_the_longest_and_shortest_frame) {
    EXPECT_EQ(worst_case_bits(8), 135U);
    EXPECT_EQ(worst_case_bits(1), 65U);
    EXPECT_EQ(worst_case_bits(0), 55U);
    EXPECT_EQ(unstuffed_bits(8), 111U);
}

// Frames per second at 1 Mbit/s, worst case.
TEST(FrameBits, give_the_known_frame_rates) {
    EXPECT_EQ(1'000'000 / worst_case_bits(8), 7407U);
    EXPECT_EQ(std::lround(1e6 / worst_case_bits(0)), 18182);
}

// A frame of dominant bits only: 1 + 11 + 3 + 4 = 19 zeros have stuff bits behind the 5th and then every 4th
// of what goes on as zeros; the CRC of zeros is zero.
TEST(FrameBits, of_a_frame_of_zeros) {
    // 34 zeros: after 5 zeros a one, then after each 5 zeros again.
    EXPECT_EQ(exact_bits(0, {}), unstuffed_bits(0) + 34 / 5);
}

TEST(FrameBits, lie_between_none_and_the_most_stuff_bits) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        std::vector<std::uint8_t> data(random() % 9);
        for (std::uint8_t& byte : data) {
            byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
        }
        const std::uint32_t bits = exact_bits(static_cast<std::uint32_t>(random() % 2048), data);
        const auto bytes = static_cast<unsigned>(data.size());
        EXPECT_GE(bits, unstuffed_bits(bytes));
        EXPECT_LE(bits, worst_case_bits(bytes));
    }
}

TEST(FrameBits, on_average_are_the_mean_over_random_contents) {
    std::mt19937 random(2);
    for (const std::uint32_t identifier : {0x000U, 0x181U, 0x555U, 0x681U, 0x7FFU}) {
        for (const unsigned bytes : {1U, 4U, 8U}) {
            double sum = 0;
            constexpr int frames = 20'000;
            for (int i = 0; i < frames; ++i) {
                std::array<std::uint8_t, 8> data{};
                for (std::uint8_t& byte : data) {
                    byte = static_cast<std::uint8_t>(random());
                }
                sum += exact_bits(identifier, std::span(data).first(bytes));
            }
            EXPECT_NEAR(average_bits(identifier, bytes), sum / frames, 0.1) << identifier << " " << bytes;
        }
    }
    EXPECT_EQ(average_bits(0x123, 0), exact_bits(0x123, {}));
}

TEST(FrameBits, of_random_frames_with_8_bytes_are_114_on_average) {
    double sum = 0;
    for (std::uint32_t identifier = 0; identifier < 2048; ++identifier) {
        sum += average_bits(identifier, 8);
    }
    EXPECT_NEAR(sum / 2048, 114, 0.5);
}

}  // namespace cgw::network
