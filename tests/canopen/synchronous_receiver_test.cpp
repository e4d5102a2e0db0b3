#include "canopen/synchronous_receiver.hpp"

#include "support/recording_port.hpp"

namespace cgw::canopen {
namespace {

using test::make_frame;

class SynchronousReceiverTest : public testing::Test {
  protected:
    using Values = std::array<std::uint8_t, 4>;
    Values values_{};
    std::array<MappedValue, 2> mapping_{{{0, 2, false}, {2, 2, false}}};
    std::array<PdoRow, 3> rows_{
        {{0x205, 2, std::span(mapping_).first(1)}, {0x305, 2, std::span(mapping_).last(1)}, {0x405, 0, {}}}};
    std::array<SynchronousReceiver::Waiting, 3> waiting_;
    SynchronousReceiver receiver_{rows_, waiting_, values_};
};

TEST_F(SynchronousReceiverTest, stores_nothing_before_the_next_sync) {
    EXPECT_EQ(receiver_.receive(make_frame(0x305, {3, 4})), std::size_t{1});
    EXPECT_EQ(values_, Values{});
    EXPECT_EQ(receiver_.sync(), 0b10U);
    EXPECT_EQ(values_, (Values{0, 0, 3, 4}));
    EXPECT_EQ(receiver_.sync(), 0U);
}

TEST_F(SynchronousReceiverTest, stores_the_newest_of_several_frames) {
    receiver_.receive(make_frame(0x205, {1, 2}));
    receiver_.receive(make_frame(0x205, {5, 6, 7}));
    receiver_.receive(make_frame(0x305, {3, 4}));
    EXPECT_EQ(receiver_.sync(), 0b11U);
    EXPECT_EQ(values_, (Values{5, 6, 3, 4}));
}

TEST_F(SynchronousReceiverTest, takes_no_short_remote_extended_or_foreign_frame) {
    EXPECT_FALSE(receiver_.receive(make_frame(0x205, {1})));
    EXPECT_FALSE(receiver_.receive(make_frame(0x206, {1, 2})));
    EXPECT_FALSE(receiver_.receive(make_frame(0x405, {1, 2})));
    frame::Frame frame = make_frame(0x205, {1, 2});
    frame.remote = true;
    EXPECT_FALSE(receiver_.receive(frame));
    frame.remote = false;
    frame.extended = true;
    EXPECT_FALSE(receiver_.receive(frame));
    EXPECT_EQ(receiver_.sync(), 0U);
}

TEST_F(SynchronousReceiverTest, forgets_what_waits_when_cancelled) {
    receiver_.receive(make_frame(0x205, {1, 2}));
    receiver_.cancel();
    EXPECT_EQ(receiver_.sync(), 0U);
    EXPECT_EQ(values_, Values{});
}

}  // namespace
}  // namespace cgw::canopen
