// What the model says about the manual's example: places, objects, parameters, times.
#include <gtest/gtest.h>

#include "signal_support.hpp"

namespace cgw::signals {
namespace {

std::string names_of(const std::vector<Frame>& frames) {
    std::string names;
    for (const Frame& frame : frames) {
        names += frame.name + ' ';
    }
    return names;
}

}  // namespace

TEST(Frames, are_those_of_the_active_pdos) {
    EXPECT_EQ(names_of(test::frames_of(test::manual_configuration())),
              "TPDO1 TPDO2 TPDO4 TPDO16 RPDO1 RPDO2 RPDO3 RPDO4 ");
    EXPECT_EQ(names_of(test::frames_of(test::empty_configuration())), "");
}

TEST(Frames, tell_identifier_length_and_times) {
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    const Frame& errors = test::frame_named(frames, "TPDO1");
    EXPECT_EQ(errors.identifier, 0x181);
    EXPECT_EQ(errors.length, 8);
    EXPECT_EQ(errors.period_us, 0U);
    const Frame& values = test::frame_named(frames, "TPDO16");
    EXPECT_EQ(values.period_us, 93750U);
    EXPECT_EQ(values.monitoring_us, 0U);
    EXPECT_EQ(values.communication, 0x180F);
    EXPECT_EQ(values.mapping, 0x1A0F);
    const Frame& received = test::frame_named(frames, "RPDO2");
    EXPECT_FALSE(received.transmit());
    EXPECT_EQ(received.period_us, 0U);
    EXPECT_EQ(received.monitoring_us, 93750U);
    EXPECT_EQ(received.communication, 0x1401);
}

TEST(Frames, keep_dummies_as_words_without_signals) {
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    const Frame& frame = test::frame_named(frames, "RPDO4");
    ASSERT_EQ(frame.words.size(), 4U);
    EXPECT_EQ(frame.words[0].index, 6);
    ASSERT_EQ(frame.signals.size(), 1U);
    EXPECT_EQ(frame.signals[0].first_bit, 48U);
    EXPECT_EQ(frame.signals[0].channel, 12);
    EXPECT_EQ(frame.signals[0].number, 917);
}

TEST(Frames, place_every_bit_once_and_in_order) {
    for (const Frame& frame : test::frames_of(test::manual_configuration())) {
        unsigned next = 0;
        for (const Signal& signal : frame.signals) {
            EXPECT_GE(signal.first_bit, next) << frame.name << ' ' << signal.name;
            next = signal.first_bit + signal.width;
            EXPECT_EQ(signal.width == 16 ? signal.first_bit % 16 : 0U, 0U);
        }
        EXPECT_LE(next, frame.length * 8U) << frame.name;
    }
}

TEST(Frames, give_an_error_bit_its_number_even_without_a_name) {
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    const Signal& signal = test::frame_named(frames, "TPDO2").signals[10];
    EXPECT_EQ(signal.number, 3074);
    EXPECT_EQ(signal.name, "Error_3074");
    EXPECT_TRUE(signal.sources.empty());
    EXPECT_EQ(signal.index, 0x2000);
    EXPECT_EQ(signal.sub_index, 5);
    EXPECT_EQ(signal.object_bit, 10);
}

TEST(Frames, name_the_functions_behind_a_switch_bit) {
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    const std::vector<Signal>& signals = test::frame_named(frames, "RPDO1").signals;
    ASSERT_EQ(signals[1].name, "FunctLoadEnable");
    ASSERT_EQ(signals[1].sources.size(), 1U);
    EXPECT_TRUE(signals[1].sources[0].low_active);
    EXPECT_EQ(signals[1].sources[0].label(), "835 FunctLoadEnable");
    ASSERT_EQ(signals[1].values.size(), 2U);
    EXPECT_EQ(signals[1].values[0].text, "on");
}

TEST(Frames, put_a_falling_internal_range_in_order) {
    const Signal signal = test::signal_of(test::scaled_row(2001, "Gap", 0, 100, 1000, 0));
    EXPECT_EQ(signal.raw_minimum, 0);
    EXPECT_EQ(signal.raw_maximum, 1000);
    EXPECT_EQ(signal.factor, -0.1);
    EXPECT_EQ(signal.offset, 100);
}

}  // namespace cgw::signals
