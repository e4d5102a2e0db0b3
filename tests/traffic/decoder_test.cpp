// What single frames and SDO transfers mean.
#include <gtest/gtest.h>

#include <random>

#include "genset.hpp"
#include "signals/encode.hpp"

namespace cgw::traffic {
namespace {

class Decode : public testing::Test {
  protected:
    std::string text(std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
        return decoder.decode(test::make_frame(id, bytes)).text;
    }

    Decoder decoder{test::genset().subject};
};

}  // namespace

TEST_F(Decode, nmt_commands) {
    EXPECT_EQ(text(0, {0x01, 0}), "start, all nodes");
    EXPECT_EQ(text(0, {0x82, 12}), "reset communication, node 12");
    EXPECT_EQ(text(0, {0x55, 12}), "unknown command 55h, node 12");
    EXPECT_EQ(text(0, {0x01}), "01, no command: it has two bytes");
    EXPECT_EQ(text(0, {}), "no data, no command: it has two bytes");
}

TEST_F(Decode, heartbeats_and_guarding) {
    EXPECT_EQ(text(0x70C, {0x00}), "node 12 boot-up");
    EXPECT_EQ(text(0x70C, {0x7F}), "node 12 Pre-Operational");
    EXPECT_EQ(text(0x701, {0x85}), "node 1 Operational, toggle bit set (node guarding)");
    EXPECT_EQ(text(0x701, {0x33}), "node 1 unknown state 33h");
    frame::Frame question;
    question.id = 0x701;
    question.remote = true;
    EXPECT_EQ(decoder.decode(question).text, "node 1 is asked for its state (node guarding)");
}

TEST_F(Decode, sync_time_emergency_and_strangers) {
    EXPECT_EQ(text(0x080, {}), "");
    EXPECT_EQ(text(0x080, {5}), "counter 5");
    EXPECT_EQ(text(0x100, {0xE8, 0x03, 0, 0, 1, 0}), "day 1 since 1984-01-01, 00:00:01.000");
    EXPECT_EQ(text(0x08B, {0x30, 0x81, 0x11, 1, 2, 3, 4, 5}),
              "node 11: 8130h life guard or heartbeat error, error register 11h, 01 02 03 04 05");
    EXPECT_EQ(text(0x08B, {0x42, 0x81, 0x11, 0, 0, 0, 0, 0}),
              "node 11: 8142h communication, error register 11h, 00 00 00 00 00");
    EXPECT_EQ(text(0x185, {0xAB}), "TPDO1 of node 5: AB");
    EXPECT_EQ(text(0x123, {0xAB}), "AB");
    EXPECT_EQ(decoder.decode(test::make_frame(0x123, {})).name, "?");
}

TEST_F(Decode, pdos_in_engineering_units) {
    EXPECT_EQ(text(0x48C, {0x00, 0x60, 0x00, 0x60, 0x00, 0x80, 0xFF, 0xFF}),
              "Speed 1500.02 1/min, SpeedSetp 1500.02 1/min, ActPos 50.0008 %, MeasuredPower 1250 kW");
    EXPECT_EQ(text(0x18C, {0, 0, 0, 0, 0, 0, 0, 0}), "no error");
    EXPECT_EQ(text(0x18C, {0x22, 0, 0, 0, 0, 0, 0, 0x80}), "error 3001, 3005 ErrSetpointExtern, 3063");
    EXPECT_EQ(text(0x38C, {0x05, 0}), "bits 1, 3");
    EXPECT_EQ(text(0x20C, {0x04, 0, 0, 0, 0x01, 0}),
              "FunctIdleSpeed off, FunctSetpoint2Or1 off, FunctLoadEnable off, faulty 900 AssignIn_Setp1Ext");
}

TEST_F(Decode, says_so_where_a_pdo_is_short_or_long) {
    EXPECT_EQ(text(0x48C, {0x00, 0x60, 0x00}), "Speed 1500.02 1/min, 3 bytes instead of 8");
    EXPECT_EQ(text(0x48C, {}), "0 bytes instead of 8");
    EXPECT_EQ(text(0x48C, {1}), "1 byte instead of 8");
    EXPECT_EQ(text(0x50C, {1, 0, 9}), "AssignIn_CurrentLoad 1 raw, 3 bytes instead of 2");
}

TEST_F(Decode, expedited_transfers_with_names_and_types) {
    EXPECT_EQ(text(0x60C, {0x40, 0x18, 0x10, 1, 0, 0, 0, 0}), "node 12 read 1018h:1 Vendor ID?");
    EXPECT_EQ(text(0x58C, {0x43, 0x18, 0x10, 1, 0x61, 1, 0, 0}),
              "node 12 answers 1018h:1 Vendor ID = 0x00000161");
    EXPECT_EQ(text(0x60C, {0x2B, 0x17, 0x10, 0, 0xF4, 1, 0, 0}),
              "node 12 write 1017h:0 Producer Heartbeat Time = 500 (0x1F4)");
    EXPECT_EQ(text(0x58C, {0x80, 0x17, 0x10, 0, 2, 0, 1, 6}),
              "node 12 refuses 1017h:0 Producer Heartbeat Time: abort 0x06010002, read-only object");
    EXPECT_EQ(text(0x58C, {0x4B, 0x01, 0x20, 1, 0x00, 0x60, 0, 0}),
              "node 12 answers 2001h:1 Speed = 1500.02 1/min");
    EXPECT_EQ(text(0x58B, {0x4F, 0x00, 0x60, 1, 0x7F, 0, 0, 0}), "node 11 answers 6000h:1 = 7F");
}

TEST_F(Decode, puts_segments_together) {
    EXPECT_EQ(text(0x60B, {0x40, 0x08, 0x10, 0, 0, 0, 0, 0}).substr(0, 21), "node 11 read 1008h:0?");
    EXPECT_EQ(text(0x58B, {0x41, 0x08, 0x10, 0, 9, 0, 0, 0}), "node 11 answers 1008h:0, in segments");
    EXPECT_EQ(text(0x60B, {0x60, 0, 0, 0, 0, 0, 0, 0}), "node 11 next segment?");
    EXPECT_EQ(text(0x58B, {0x00, 1, 2, 3, 4, 5, 6, 7}), "node 11 segment, 7 bytes so far");
    EXPECT_EQ(text(0x58B, {0x1B, 8, 9, 0, 0, 0, 0, 0}),
              "node 11 has answered 1008h:0 = 01 02 03 04 05 06 07 08 09");
    EXPECT_EQ(text(0x58B, {0x1B, 8, 9, 0, 0, 0, 0, 0}),
              "node 11 segment of a transfer that is not in the log: 08 09 00 00 00 00 00");
    text(0x60B, {0x21, 0x10, 0x10, 1, 9, 0, 0, 0});
    EXPECT_EQ(text(0x60B, {0x0D, 0x73, 0, 0, 0, 0, 0, 0}), "node 11 write 1010h:1 = 73");
}

TEST_F(Decode, counts_more_of_a_transfer_than_it_keeps) {
    text(0x60B, {0x21, 0x10, 0x30, 1, 0, 0, 0, 0});
    std::string last;
    for (int i = 0; i < 99; ++i) {
        text(0x60B, {0x00, 1, 2, 3, 4, 5, 6, 7});
    }
    last = text(0x60B, {0x01, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_TRUE(last.ends_with(" … (700 bytes)")) << last;
}

TEST_F(Decode, leaves_blocks_alone_to_their_end) {
    text(0x60B, {0xA0, 0x08, 0x10, 0, 16, 0, 0, 0});
    EXPECT_EQ(text(0x58B, {0x82, 0x40, 0x08, 0x10, 0, 0, 0, 0}),
              "node 11 block transfer of 1008h:0: 82 40 08 10 00 00 00 00");
    EXPECT_EQ(text(0x60B, {0xA1, 0, 0, 0, 0, 0, 0, 0}), "node 11 block transfer of 1008h:0 is complete");
    EXPECT_EQ(text(0x60B, {0x40, 0x18, 0x10, 4, 0, 0, 0, 0}).substr(0, 20), "node 11 read 1018h:4");
}

// Every raw value of every signal, encoded and decoded: the text is that of the signal.
TEST_F(Decode, gives_back_what_encode_was_given) {
    std::mt19937 random(3);
    for (const signals::Frame& frame : test::genset().subject.frames) {
        for (int round = 0; round < 100; ++round) {
            std::vector<std::string> values;
            std::vector<std::string> expected;
            for (const signals::Signal& signal : frame.signals) {
                std::uniform_int_distribution<std::int32_t> any(signal.raw_minimum, signal.raw_maximum);
                const std::string value = signals::value_text(signal, any(random));
                values.push_back(signal.name + "=" + value);
                expected.push_back(signal.name + " " + value);
            }
            diagnostic::Findings findings;
            const signals::Encoded encoded = signals::encode(frame, values, findings);
            ASSERT_TRUE(findings.all().empty());
            const frame::Frame sent{.id = frame.identifier,
                                    .length = frame.length,
                                    .extended = false,
                                    .remote = false,
                                    .data = encoded.data};
            const std::string decoded = decoder.decode(sent).text;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const signals::Kind kind = frame.signals[i].kind;
                if (kind == signals::Kind::measurement || kind == signals::Kind::sensor ||
                    kind == signals::Kind::switch_function) {
                    ASSERT_NE(decoded.find(expected[i]), std::string::npos) << decoded << "\n" << expected[i];
                }
            }
        }
    }
}

TEST_F(Decode, survives_any_frame) {
    std::mt19937 random(17);
    for (int round = 0; round < 100'000; ++round) {
        frame::Frame frame;
        frame.id = static_cast<std::uint32_t>(random()) & 0x7FFU;
        frame.extended = random() % 16 == 0;
        frame.remote = random() % 16 == 0;
        frame.length = static_cast<std::uint8_t>(random() % 9);
        for (std::uint8_t& byte : frame.data) {
            byte = static_cast<std::uint8_t>(random());
        }
        const Meaning meaning = decoder.decode(frame);
        ASSERT_FALSE(meaning.name.empty());
        ASSERT_EQ(meaning.text.find('\n'), std::string::npos);
    }
}

}  // namespace cgw::traffic
