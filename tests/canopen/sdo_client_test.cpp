#include "canopen/sdo_client.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using object::AbortCode;
using test::make_frame;
using test::RecordingPort;
using Status = SdoClient::Status;

class SdoClientTest : public testing::Test {
  protected:
    RecordingPort port_;
    SdoClient client_{5, 1000};
};

TEST_F(SdoClientTest, uploads_one_two_and_four_bytes) {
    const std::vector<std::pair<std::uint8_t, std::uint32_t>> cases = {
        {0x4F, 0x44}, {0x4B, 0x3344}, {0x43, 0x11223344}, {0x42, 0x11223344}};
    for (const auto& [command, value] : cases) {
        ASSERT_TRUE(client_.upload({0x1018, 1}));
        client_.poll(0, port_);
        EXPECT_EQ(port_.take(), (std::vector{make_frame(0x605, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0})}));
        EXPECT_EQ(client_.status(), Status::busy);
        client_.receive(make_frame(0x585, {command, 0x18, 0x10, 1, 0x44, 0x33, 0x22, 0x11}));
        EXPECT_EQ(client_.status(), Status::done);
        EXPECT_EQ(client_.value(), value);
    }
    EXPECT_EQ(client_.length(), 4);
}

TEST_F(SdoClientTest, downloads_with_the_length_stated) {
    ASSERT_TRUE(client_.download({0x1017, 0}, 500, 2));
    client_.poll(0, port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x605, {0x2B, 0x17, 0x10, 0, 0xF4, 0x01, 0, 0})}));
    client_.receive(make_frame(0x585, {0x60, 0x17, 0x10, 0, 0, 0, 0, 0}));
    EXPECT_EQ(client_.status(), Status::done);
}

TEST_F(SdoClientTest, reports_the_abort_code_of_the_server) {
    client_.download({0x1017, 0}, 500, 2);
    client_.poll(0, port_);
    client_.receive(make_frame(0x585, {0x80, 0x17, 0x10, 0, 0x02, 0x00, 0x01, 0x06}));
    EXPECT_EQ(client_.status(), Status::aborted);
    EXPECT_EQ(client_.abort_code(), AbortCode::read_only);
}

TEST_F(SdoClientTest, gives_up_after_the_timeout_and_tells_the_server) {
    client_.upload({0x1018, 1});
    EXPECT_EQ(client_.poll(100, port_), 1100U);
    port_.take();
    client_.poll(1099, port_);
    EXPECT_EQ(client_.status(), Status::busy);
    client_.poll(1100, port_);
    EXPECT_EQ(client_.status(), Status::aborted);
    EXPECT_EQ(client_.abort_code(), AbortCode::timed_out);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x605, {0x80, 0x18, 0x10, 1, 0x00, 0x00, 0x04, 0x05})}));
}

TEST_F(SdoClientTest, ignores_a_late_answer_for_another_object) {
    client_.upload({0x1018, 2});
    client_.poll(0, port_);
    client_.receive(make_frame(0x585, {0x43, 0x18, 0x10, 1, 1, 1, 1, 1}));
    client_.receive(make_frame(0x586, {0x43, 0x18, 0x10, 2, 1, 1, 1, 1}));
    client_.receive(make_frame(0x585, {0x43, 0x18, 0x10, 2}));
    EXPECT_EQ(client_.status(), Status::busy);
}

TEST_F(SdoClientTest, refuses_a_second_transfer_while_busy) {
    ASSERT_TRUE(client_.upload({0x1018, 2}));
    EXPECT_FALSE(client_.upload({0x1018, 3}));
    EXPECT_FALSE(client_.download({0x1018, 3}, 1, 1));
}

TEST_F(SdoClientTest, keeps_the_request_for_a_port_that_says_not_now) {
    port_.room = 0;
    client_.upload({0x1018, 2});
    EXPECT_EQ(client_.poll(0, port_), never);
    EXPECT_TRUE(client_.pending());
    port_.room = 1;
    EXPECT_EQ(client_.poll(5000, port_), 6000U);
    EXPECT_FALSE(client_.pending());
    EXPECT_EQ(port_.sent.size(), 1U);
}

TEST_F(SdoClientTest, gives_up_on_an_answer_it_cannot_carry) {
    client_.upload({0x1008, 0});
    client_.poll(0, port_);
    port_.take();
    client_.receive(make_frame(0x585, {0x41, 0x08, 0x10, 0, 20, 0, 0, 0}));  // segmented
    EXPECT_EQ(client_.status(), Status::aborted);
    EXPECT_EQ(client_.abort_code(), AbortCode::command_unknown);
    client_.poll(1, port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x605, {0x80, 0x08, 0x10, 0, 0x01, 0x00, 0x04, 0x05})}));
}

}  // namespace
}  // namespace cgw::canopen
