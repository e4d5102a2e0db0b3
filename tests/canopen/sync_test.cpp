#include "canopen/sync.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;
using Kind = SyncConsumer::Sync::Kind;

TEST(SyncConsumer, takes_a_sync_of_its_identifier) {
    const SyncConsumer consumer(0x80);
    EXPECT_EQ(consumer.receive(make_frame(0x80, {})).kind, Kind::sync);
    EXPECT_EQ(consumer.receive(make_frame(0x80, {})).counter, 0);
    EXPECT_EQ(consumer.receive(make_frame(0x81, {})).kind, Kind::none);
    frame::Frame frame = make_frame(0x80, {});
    frame.remote = true;
    EXPECT_EQ(consumer.receive(frame).kind, Kind::none);
    frame.remote = false;
    frame.extended = true;
    EXPECT_EQ(consumer.receive(frame).kind, Kind::none);
}

TEST(SyncConsumer, demands_a_counter_exactly_when_one_is_configured) {
    EXPECT_EQ(SyncConsumer(0x80).receive(make_frame(0x80, {1})).kind, Kind::wrong_length);
    const SyncConsumer counting(0x80, 10);
    EXPECT_EQ(counting.receive(make_frame(0x80, {})).kind, Kind::wrong_length);
    EXPECT_EQ(counting.receive(make_frame(0x80, {1, 2})).kind, Kind::wrong_length);
    EXPECT_EQ(counting.receive(make_frame(0x80, {7})).kind, Kind::sync);
    EXPECT_EQ(counting.receive(make_frame(0x80, {7})).counter, 7);
}

class SyncProducerTest : public testing::Test {
  protected:
    test::RecordingPort port_;
};

TEST_F(SyncProducerTest, is_silent_before_its_start_after_its_stop_and_without_a_period) {
    SyncProducer producer(0x80, 1000);
    EXPECT_EQ(producer.poll(5000, port_), never);
    producer.start(5000);
    producer.stop();
    EXPECT_EQ(producer.poll(6000, port_), never);
    SyncProducer none(0x80, 0);
    none.start(0);
    EXPECT_EQ(none.poll(0, port_), never);
    EXPECT_TRUE(port_.sent.empty());
}

TEST_F(SyncProducerTest, keeps_its_rhythm) {
    SyncProducer producer(0x80, 1000);
    producer.start(500);
    EXPECT_EQ(producer.poll(500, port_), 1500U);
    EXPECT_EQ(producer.poll(1499, port_), 1500U);
    EXPECT_EQ(producer.poll(1700, port_), 2500U);
    EXPECT_EQ(producer.poll(5600, port_), 6500U);
    EXPECT_EQ(port_.take(), (std::vector<frame::Frame>(3, make_frame(0x80, {}))));
}

TEST_F(SyncProducerTest, counts_from_1_to_its_overflow) {
    SyncProducer producer(0x80, 10, 3);
    producer.start(0);
    for (Time now = 0; now < 50; now += 10) {
        producer.poll(now, port_);
    }
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x80, {1}), make_frame(0x80, {2}), make_frame(0x80, {3}),
                                         make_frame(0x80, {1}), make_frame(0x80, {2})}));
}

TEST_F(SyncProducerTest, offers_again_what_the_port_did_not_take) {
    SyncProducer producer(0x80, 10, 3);
    producer.start(0);
    port_.room = 0;
    producer.poll(0, port_);
    EXPECT_TRUE(producer.pending());
    producer.poll(25, port_);
    port_.room = test::RecordingPort::unlimited;
    EXPECT_EQ(producer.poll(26, port_), 30U);
    EXPECT_FALSE(producer.pending());
    EXPECT_EQ(port_.take(), (std::vector{make_frame(0x80, {1})}));
}

}  // namespace
}  // namespace cgw::canopen
