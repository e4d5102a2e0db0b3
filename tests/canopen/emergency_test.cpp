#include "canopen/emergency.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using object::AbortCode;
using test::make_frame;
using test::RecordingPort;

constexpr Emergency over_speed{0x1001, 0x01, {0xC1, 0x0B, 0x34, 0x12, 0x00}};

TEST(EmergencyFrame, holds_code_register_and_the_manufacturers_bytes) {
    EXPECT_EQ(emergency_frame(0x085, over_speed),
              make_frame(0x085, {0x01, 0x10, 0x01, 0xC1, 0x0B, 0x34, 0x12, 0x00}));
}

TEST(EmergencyFrame, is_read_back) {
    const std::optional<ReceivedEmergency> received = read_emergency(emergency_frame(0x0FF, over_speed));
    ASSERT_TRUE(received);
    EXPECT_EQ(received->node_id, 127);
    EXPECT_EQ(received->emergency, over_speed);
}

TEST(EmergencyFrame, is_none_of_another_identifier_length_or_kind) {
    EXPECT_FALSE(read_emergency(emergency_frame(0x080, over_speed)));  // SYNC
    EXPECT_FALSE(read_emergency(emergency_frame(0x100, over_speed)));
    EXPECT_FALSE(read_emergency(make_frame(0x085, {1, 2, 3, 4, 5, 6, 7})));
    frame::Frame frame = emergency_frame(0x085, over_speed);
    frame.remote = true;
    EXPECT_FALSE(read_emergency(frame));
    frame.remote = false;
    frame.extended = true;
    EXPECT_FALSE(read_emergency(frame));
}

class EmergencyProducerTest : public testing::Test {
  protected:
    static Emergency error(std::uint16_t code) { return {code, 1, {}}; }
    std::vector<std::uint16_t> codes() {
        std::vector<std::uint16_t> result;
        for (const frame::Frame& frame : port_.take()) {
            result.push_back(read_emergency(frame).value().emergency.code);
        }
        return result;
    }
    using Codes = std::vector<std::uint16_t>;
    RecordingPort port_;
};

TEST_F(EmergencyProducerTest, sends_each_emergency_once_and_in_order) {
    EmergencyProducer producer(0x085, 0);
    producer.report(error(1));
    producer.report(error(2));
    producer.report(error(Emergency::no_error));
    EXPECT_EQ(producer.poll(0, port_), never);
    EXPECT_EQ(codes(), (Codes{1, 2, 0}));
    producer.poll(1, port_);
    EXPECT_TRUE(port_.sent.empty());
    EXPECT_EQ(producer.counters().sent, 3U);
}

TEST_F(EmergencyProducerTest, keeps_the_inhibit_time) {
    EmergencyProducer producer(0x085, 1000);
    producer.report(error(1));
    producer.report(error(2));
    EXPECT_EQ(producer.poll(500, port_), 1500U);
    EXPECT_FALSE(producer.pending());  // time is waited for, not the port
    EXPECT_EQ(producer.poll(1499, port_), 1500U);
    EXPECT_EQ(codes(), Codes{1});
    EXPECT_EQ(producer.poll(1500, port_), never);
    EXPECT_EQ(codes(), Codes{2});
    producer.report(error(3));
    EXPECT_EQ(producer.poll(1600, port_), 2500U);
}

TEST_F(EmergencyProducerTest, keeps_what_the_port_does_not_take) {
    EmergencyProducer producer(0x085, 1000);
    producer.report(error(1));
    port_.room = 0;
    producer.poll(0, port_);
    EXPECT_TRUE(producer.pending());
    producer.report(error(2));
    port_.room = RecordingPort::unlimited;
    EXPECT_EQ(producer.poll(700, port_), 1700U);  // counted from the frame that left
    EXPECT_FALSE(producer.pending());
    producer.poll(1700, port_);
    EXPECT_EQ(codes(), (Codes{1, 2}));
}

TEST_F(EmergencyProducerTest, drops_and_counts_what_finds_no_room) {
    EmergencyProducer producer(0x085, 0);
    Codes expected;
    for (std::uint16_t code = 1; code <= EmergencyProducer::capacity; ++code) {
        EXPECT_TRUE(producer.report(error(code)));
        expected.push_back(code);
    }
    EXPECT_FALSE(producer.report(error(99)));
    EXPECT_EQ(producer.counters().dropped, 1U);
    producer.poll(0, port_);
    EXPECT_EQ(codes(), expected);
    EXPECT_TRUE(producer.report(error(100)));
}

TEST_F(EmergencyProducerTest, forgets_what_waits_when_cleared) {
    EmergencyProducer producer(0x085, 0);
    producer.report(error(1));
    producer.clear();
    producer.poll(0, port_);
    EXPECT_TRUE(port_.sent.empty());
}

class ErrorHistoryTest : public testing::Test {
  protected:
    std::pair<AbortCode, std::uint32_t> read(std::uint8_t sub_index) const {
        std::uint32_t value = 0;
        const AbortCode code = history_.read(sub_index, value);
        return {code, value};
    }
    std::array<std::uint32_t, 3> entries_{};
    ErrorHistory history_{entries_};
};

TEST_F(ErrorHistoryTest, is_empty_at_first) {
    EXPECT_EQ(read(0), std::pair(AbortCode::none, 0U));
    EXPECT_EQ(read(1).first, AbortCode::no_data);
}

TEST_F(ErrorHistoryTest, has_the_newest_error_first_and_forgets_the_oldest) {
    for (std::uint16_t code = 1; code <= 4; ++code) {
        history_.add(code, static_cast<std::uint16_t>(0x1000 + code));
    }
    EXPECT_EQ(read(0).second, 3U);
    EXPECT_EQ(read(1).second, 0x10040004U);
    EXPECT_EQ(read(3).second, 0x10020002U);
    EXPECT_EQ(read(4).first, AbortCode::no_data);
}

TEST_F(ErrorHistoryTest, is_cleared_by_writing_0_to_sub_0_and_takes_nothing_else) {
    history_.add(1, 0);
    EXPECT_EQ(history_.write(0, 1), AbortCode::value_invalid);
    EXPECT_EQ(history_.write(1, 0), AbortCode::read_only);
    EXPECT_EQ(history_.count(), 1U);
    EXPECT_EQ(history_.write(0, 0), AbortCode::none);
    EXPECT_EQ(history_.count(), 0U);
    EXPECT_EQ(read(1).first, AbortCode::no_data);
}

TEST(ErrorHistory, without_room_remembers_nothing) {
    ErrorHistory history;
    history.add(1, 2);
    EXPECT_EQ(history.count(), 0U);
}

}  // namespace
}  // namespace cgw::canopen
