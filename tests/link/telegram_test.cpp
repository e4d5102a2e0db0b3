#include "link/telegram.hpp"

#include <gtest/gtest.h>

namespace cgw::link {
namespace {

constexpr Address governor{DeviceType::governor, 3};
constexpr Address gateway{DeviceType::gateway, 31};

TEST(Telegram, says_kind_sender_and_receiver_in_its_identifier) {
    EXPECT_EQ(identifier(kind_of(Kind::cycle), governor, gateway), 0x1539235FU);
    frame::Frame frame = make_telegram(kind_of(Kind::analogue, 16), governor, gateway, 8);
    frame.data[7] = 0xAA;
    const std::optional<Telegram> read = read_telegram(frame);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->kind, 0x30);
    EXPECT_EQ(read->from, governor);
    EXPECT_EQ(read->to, gateway);
    EXPECT_EQ(read->length, 8);
    EXPECT_EQ(read->data[7], 0xAA);
}

TEST(Telegram, takes_nothing_that_is_none_of_the_links) {
    const frame::Frame good = make_telegram(kind_of(Kind::status), gateway, governor, 8);
    frame::Frame frame = good;
    frame.extended = false;
    EXPECT_FALSE(read_telegram(frame));
    frame = good;
    frame.remote = true;
    EXPECT_FALSE(read_telegram(frame));
    frame = good;
    frame.id ^= 0x01000000;
    EXPECT_FALSE(read_telegram(frame));
}

TEST(Telegram, lets_commands_win_over_data_and_data_over_configuration) {
    const auto id = [](std::uint8_t kind) { return identifier(kind, governor, gateway); };
    EXPECT_LT(id(kind_of(Kind::command)), id(kind_of(Kind::process_data, 1)));
    EXPECT_LT(id(kind_of(Kind::process_data, 4)), id(kind_of(Kind::analogue, 4)));
    EXPECT_LT(id(kind_of(Kind::analogue, 16)), id(kind_of(Kind::errors_first)));
    EXPECT_LT(id(kind_of(Kind::errors_first)), id(kind_of(Kind::cycle)));
    EXPECT_LT(id(kind_of(Kind::cycle)), id(kind_of(Kind::configuration)));
}

}  // namespace
}  // namespace cgw::link
