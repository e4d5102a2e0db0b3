// Bytes, raw values and physical values, there and back.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "base/numbers.hpp"
#include "signal_support.hpp"
#include "signals/codec.hpp"

namespace cgw::signals {
namespace {

const parameter::Row speed_row = [] {
    parameter::Row row = test::scaled_row(2000, "Speed", 0, 4000);
    row.unit = "1/min";
    return row;
}();

}  // namespace

TEST(Codec, reads_words_low_byte_first) {
    const Signal signal = test::signal_of(test::row::speed);
    EXPECT_EQ(raw_value(signal, Data{0x34, 0x12}), 0x1234);
    const Signal with_sign = test::signal_of(test::row::charge_air_temperature);
    EXPECT_EQ(raw_value(with_sign, Data{0xFE, 0xFF}), -2);
    Data data{};
    put_raw(with_sign, data, -2);
    EXPECT_EQ(data, (Data{0xFE, 0xFF}));
}

TEST(Codec, sets_and_clears_a_bit_alone) {
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    const Signal& signal = test::frame_named(frames, "RPDO1").signals[1];  // bit 5 of word 1
    Data data{0xFF, 0xFF, 0, 0xFF};
    put_raw(signal, data, 0);
    EXPECT_EQ(data, (Data{0xEF, 0xFF, 0, 0xFF}));
    put_raw(signal, data, 1);
    EXPECT_EQ(data, (Data{0xFF, 0xFF, 0, 0xFF}));
}

TEST(Codec, knows_where_a_short_frame_ends) {
    const Signal signal = test::signal_of(test::row::speed);
    const Data data{};
    EXPECT_TRUE(reaches(signal, std::span(data).first(2)));
    EXPECT_FALSE(reaches(signal, std::span(data).first(1)));
    EXPECT_FALSE(reaches(signal, {}));
}

TEST(Codec, writes_values_for_people) {
    const Signal signal = test::signal_of(speed_row);
    EXPECT_EQ(value_text(signal, 0), "0 1/min");
    EXPECT_EQ(value_text(signal, 32768), "2000.03 1/min");
    EXPECT_EQ(range_text(signal), "0..4000 1/min");
    EXPECT_EQ(scaling_text(signal), "0..65535 is 0..4000 1/min");
    EXPECT_EQ(value_text(test::signal_of(test::row::speed), 8000), "8000 raw");
    EXPECT_EQ(scaling_text(test::signal_of(test::row::speed)), "not known");
    const std::vector<Frame> frames = test::frames_of(test::manual_configuration());
    EXPECT_EQ(value_text(test::frame_named(frames, "RPDO1").signals[1], 0), "on");
    EXPECT_EQ(range_text(test::frame_named(frames, "RPDO1").signals[1]), "on or off");
    EXPECT_EQ(value_text(test::frame_named(frames, "TPDO1").signals[0], 1), "1");
}

TEST(Codec, never_writes_a_negative_zero) {
    EXPECT_EQ(value_text(test::signal_of(test::scaled_row(2001, "Trim", -0.0004, 0.0004, -4, 4)), 0), "0");
}

TEST(Codec, writes_no_noise_of_binary_fractions) {
    const Signal signal = test::signal_of(test::scaled_row(2001, "Leakage", 1e-6, 1e-3));
    EXPECT_EQ(quantity_text(signal, 0.1 + 0.2), "0.3");
}

TEST(Codec, refuses_what_is_beyond_the_range) {
    const Signal signal = test::signal_of(speed_row);
    EXPECT_EQ(raw_of(signal, 4000), 65535);
    EXPECT_EQ(raw_of(signal, 4000.01), 65535);  // rounding of a text
    EXPECT_FALSE(raw_of(signal, 4001));
    EXPECT_FALSE(raw_of(signal, -1));
    EXPECT_FALSE(raw_of(signal, std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(raw_of(signal, std::numeric_limits<double>::quiet_NaN()));
}

TEST(Codec, survives_a_scaling_beyond_all_measure) {
    constexpr double huge = std::numeric_limits<double>::max();
    const Signal signal = test::signal_of(test::scaled_row(2001, "Huge", -huge, huge, -10, 10));
    EXPECT_FALSE(raw_of(signal, 1.0).has_value() && raw_of(signal, 1.0) != 0);
    EXPECT_NE(value_text(signal, 5), "");
    const Signal tiny = test::signal_of(test::scaled_row(2001, "Tiny", 0, 1e-300));
    EXPECT_NE(value_text(tiny, 5), "");
}

TEST(Codec, knows_the_width) {
    const Signal signal = test::signal_of(test::row::charge_air_temperature);
    EXPECT_TRUE(can_carry(signal, -32768));
    EXPECT_FALSE(can_carry(signal, 32768));
    EXPECT_FALSE(can_carry(test::signal_of(test::row::speed), -1));
    EXPECT_FALSE(can_carry(test::signal_of(test::row::speed), 65536));
}

// Every raw value of a range, as text and back.
TEST(Codec, reads_back_what_it_writes) {
    const parameter::Row rows[] = {
        speed_row,
        test::scaled_row(2907, "Temp", -100, 1000, -1000, 10000),
        test::scaled_row(2001, "Falling", 50, -50, 0, 255),
        test::scaled_row(2002, "Turned", 0, 100, 1000, 0),
        test::scaled_row(2003, "Fine", 0.05, 0.15, -32768, 32767),
        test::make_row(2004, "Raw", true),
    };
    for (const parameter::Row& row : rows) {
        const Signal signal = test::signal_of(row);
        for (std::int32_t raw = signal.raw_minimum; raw <= signal.raw_maximum; ++raw) {
            const auto physical = base::parse_real(physical_text(signal, raw));
            ASSERT_TRUE(physical) << row.name << ' ' << raw;
            ASSERT_EQ(raw_of(signal, *physical), raw) << row.name << ' ' << physical_text(signal, raw);
        }
    }
}

TEST(Codec, puts_random_values_of_all_signals_beside_each_other) {
    std::mt19937 random(7);
    for (const Frame& frame : test::frames_of(test::manual_configuration())) {
        for (int round = 0; round < 200; ++round) {
            Data data{};
            std::vector<std::int32_t> expected;
            for (const Signal& signal : frame.signals) {
                std::uniform_int_distribution<std::int32_t> any(signal.raw_minimum, signal.raw_maximum);
                expected.push_back(any(random));
                put_raw(signal, data, expected.back());
            }
            for (std::size_t i = 0; i < expected.size(); ++i) {
                ASSERT_EQ(raw_value(frame.signals[i], data), expected[i]) << frame.signals[i].name;
            }
        }
    }
}

}  // namespace cgw::signals
