#include "canopen/pdo.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using test::RecordingPort;

// Three rows: 4 bytes, inactive, 3 bytes from a word and a byte.
class PdoTest : public testing::Test {
  protected:
    std::array<std::uint8_t, 8> values_{0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88};
    std::array<MappedValue, 4> mapping_{{{0, 2, false}, {4, 2, false}, {2, 2, false}, {7, 1, false}}};
    std::array<PdoRow, 3> rows_{
        {{0x181, 4, std::span(mapping_).first(2)}, {0x281, 0, {}}, {0x381, 3, std::span(mapping_).last(2)}}};
    std::array<TransmitState, 3> states_{};
    PdoTransmitter transmitter_{rows_, states_, values_};
    RecordingPort port_;
};

TEST_F(PdoTest, builds_frames_from_mapped_values) {
    transmitter_.request(0);
    transmitter_.request(2);
    EXPECT_TRUE(transmitter_.send_pending(port_));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x181, {0x11, 0x22, 0x55, 0x66}),
                                         make_frame(0x381, {0x33, 0x44, 0x88})}));
    EXPECT_EQ(transmitter_.counters().sent, 2U);
}

TEST_F(PdoTest, never_sends_an_inactive_row) {
    transmitter_.request(1);
    transmitter_.request_if_changed(1);
    EXPECT_FALSE(transmitter_.pending());
    EXPECT_TRUE(transmitter_.send_pending(port_));
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(PdoTest, requests_on_change_only_after_a_change) {
    transmitter_.request(0);
    transmitter_.send_pending(port_);
    port_.take();
    transmitter_.request_if_changed(0);
    EXPECT_FALSE(transmitter_.pending());
    values_[3] = 0xAA;  // not mapped by row 0
    transmitter_.request_if_changed(0);
    EXPECT_FALSE(transmitter_.pending());
    values_[5] = 0xAA;
    transmitter_.request_if_changed(0);
    transmitter_.send_pending(port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x181, {0x11, 0x22, 0x55, 0xAA})}));
}

TEST_F(PdoTest, keeps_a_change_that_the_port_did_not_take) {
    transmitter_.request(0);
    transmitter_.send_pending(port_);
    port_.take();
    port_.room = 0;
    values_[0] = 0x01;
    transmitter_.request_if_changed(0);
    EXPECT_FALSE(transmitter_.send_pending(port_));
    EXPECT_TRUE(transmitter_.pending());
    EXPECT_EQ(transmitter_.counters().deferred, 1U);
    port_.room = RecordingPort::unlimited;
    EXPECT_TRUE(transmitter_.send_pending(port_));
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x181, {0x01, 0x22, 0x55, 0x66})}));
}

TEST_F(PdoTest, sends_the_newest_data_once_when_requested_again_while_waiting) {
    port_.room = 0;
    transmitter_.request(0);
    transmitter_.send_pending(port_);
    values_[0] = 0x99;
    transmitter_.request(0);
    EXPECT_EQ(transmitter_.counters().superseded, 1U);
    port_.room = RecordingPort::unlimited;
    transmitter_.send_pending(port_);
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x181, {0x99, 0x22, 0x55, 0x66})}));
}

TEST_F(PdoTest, starves_no_pdo_behind_a_slow_port) {
    std::size_t third_row = 0;
    for (int round = 0; round < 10; ++round) {
        transmitter_.request(0);
        transmitter_.request(2);
        port_.room = 1;
        transmitter_.send_pending(port_);
        third_row += port_.take().front().id == 0x381 ? 1U : 0U;
    }
    EXPECT_EQ(third_row, 5U);
}

TEST_F(PdoTest, forgets_what_waits_when_cancelled) {
    transmitter_.request(0);
    transmitter_.cancel();
    EXPECT_FALSE(transmitter_.pending());
    transmitter_.send_pending(port_);
    EXPECT_TRUE(port_.sent.empty());
}

std::vector<std::array<int, 3>> joined(std::vector<MappedValue> mapping) {
    mapping.resize(join_neighbours(mapping));
    std::vector<std::array<int, 3>> result;
    for (const MappedValue& value : mapping) {
        result.push_back({value.offset, value.length, value.dummy ? 1 : 0});
    }
    return result;
}

TEST(PdoMapping, joins_values_that_follow_each_other) {
    using Runs = std::vector<std::array<int, 3>>;
    EXPECT_EQ(joined({}), Runs());
    EXPECT_EQ(joined({{4, 2, false}, {6, 2, false}, {8, 1, false}}), (Runs{{4, 5, 0}}));
    EXPECT_EQ(joined({{4, 2, false}, {8, 2, false}, {6, 2, false}}), (Runs{{4, 2, 0}, {8, 2, 0}, {6, 2, 0}}));
    EXPECT_EQ(joined({{4, 2, false}, {4, 2, false}}), (Runs{{4, 2, 0}, {4, 2, 0}}));
}

TEST(PdoMapping, joins_dummies_with_dummies_only) {
    using Runs = std::vector<std::array<int, 3>>;
    EXPECT_EQ(joined({{0, 2, true}, {0, 2, true}, {4, 2, false}}), (Runs{{0, 4, 1}, {4, 2, 0}}));
    EXPECT_EQ(joined({{0, 2, false}, {0, 2, true}, {2, 2, false}}), (Runs{{0, 2, 0}, {0, 2, 1}, {2, 2, 0}}));
}

class PdoReceiveTest : public testing::Test {
  protected:
    std::array<std::uint8_t, 6> values_{};
    std::array<MappedValue, 3> mapping_{{{0, 2, false}, {0, 2, true}, {4, 2, false}}};
    std::array<PdoRow, 2> rows_{{{0x201, 0, {}}, {0x301, 6, mapping_}}};
    PdoReceiver receiver_{rows_, values_};
};

TEST_F(PdoReceiveTest, stores_words_and_skips_dummies) {
    EXPECT_EQ(receiver_.receive(make_frame(0x301, {1, 2, 3, 4, 5, 6})), std::size_t{1});
    EXPECT_EQ(values_, (std::array<std::uint8_t, 6>{1, 2, 0, 0, 5, 6}));
    EXPECT_EQ(receiver_.counters().received, 1U);
}

TEST_F(PdoReceiveTest, takes_the_first_bytes_of_a_longer_frame) {
    EXPECT_TRUE(receiver_.receive(make_frame(0x301, {1, 2, 3, 4, 5, 6, 7, 8})).has_value());
    EXPECT_EQ(values_, (std::array<std::uint8_t, 6>{1, 2, 0, 0, 5, 6}));
}

TEST_F(PdoReceiveTest, does_not_process_a_shorter_frame) {
    EXPECT_FALSE(receiver_.receive(make_frame(0x301, {1, 2, 3, 4, 5})).has_value());
    EXPECT_EQ(values_, (std::array<std::uint8_t, 6>{}));
    EXPECT_EQ(receiver_.counters().too_short, 1U);
}

TEST_F(PdoReceiveTest, ignores_inactive_rows_remote_and_extended_frames_and_strangers) {
    EXPECT_FALSE(receiver_.receive(make_frame(0x201, {1, 2, 3, 4, 5, 6})).has_value());
    EXPECT_FALSE(receiver_.receive(make_frame(0x302, {1, 2, 3, 4, 5, 6})).has_value());
    frame::Frame frame = make_frame(0x301, {1, 2, 3, 4, 5, 6});
    frame.remote = true;
    EXPECT_FALSE(receiver_.receive(frame).has_value());
    frame.remote = false;
    frame.extended = true;
    EXPECT_FALSE(receiver_.receive(frame).has_value());
    EXPECT_EQ(receiver_.counters().received, 0U);
}

}  // namespace
}  // namespace cgw::canopen
