#include "media/candump.hpp"

#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using test::make_frame;

LoggedFrame logged(std::uint64_t time_us, const frame::Frame& frame) {
    return {time_us, "can0", frame};
}

TEST(Candump, writes_a_data_frame) {
    EXPECT_EQ(candump_line(logged(12'345'678, make_frame(0x123, {0x11, 0xA2}))),
              "(0000000012.345678) can0 123#11A2");
    EXPECT_EQ(candump_line(logged(0, make_frame(0, {}))), "(0000000000.000000) can0 000#");
}

TEST(Candump, writes_extended_and_remote_frames) {
    frame::Frame frame = make_frame(0x123, {1});
    frame.extended = true;
    EXPECT_EQ(candump_line(logged(1, frame)), "(0000000000.000001) can0 00000123#01");
    frame = {};
    frame.id = 0x705;
    frame.remote = true;
    EXPECT_EQ(candump_line(logged(1, frame)), "(0000000000.000001) can0 705#R");
    frame.length = 4;
    EXPECT_EQ(candump_line(logged(1, frame)), "(0000000000.000001) can0 705#R4");
}

TEST(Candump, reads_what_it_writes) {
    frame::Frame extended = make_frame(0x1ABCDEF0, {1, 2, 3});
    extended.extended = true;
    frame::Frame remote;
    remote.id = 0x705;
    remote.remote = true;
    remote.length = 2;
    for (const frame::Frame& frame :
         {make_frame(0x7FF, {1, 2, 3, 4, 5, 6, 7, 8}), make_frame(0, {}), extended, remote}) {
        const LoggedFrame original = logged(1'700'000'000'123'456, frame);
        EXPECT_EQ(parse_candump_line(candump_line(original)), original);
    }
}

TEST(Candump, refuses_every_other_line) {
    for (const char* line : {"",
                             "(",
                             "hello",
                             "(1.000000)",
                             "(1.000000) can0",
                             "(1.000000) can0 123",
                             "(1.0) can0 123#",
                             "(1.00000x) can0 123#",
                             "(1.0000000) can0 123#",
                             "(1.00000000x) can0 123#",
                             "(x.000000) can0 123#",
                             "(1.000000) 123#",
                             "(1.000000)  123#",
                             "(1.000000)can0 123#",
                             "(1.000000) can0 12#",
                             "(1.000000) can0 1234#",
                             "(1.000000) can0 800#",
                             "(1.000000) can0 20000000#",
                             "(1.000000) can0 12G#",
                             "(1.000000) can0 123#1",
                             "(1.000000) can0 123#1G",
                             "(1.000000) can0 123#112233445566778899",
                             "(1.000000) can0 123#R9",
                             "(1.000000) can0 123#R12",
                             "(1.000000) can0 123##011",
                             "(99999999999999999999.000000) can0 123#",
                             "(18446744073709551615.000000) can0 123#",
                             "(1.000000) can0 123#11 ",
                             "(-1.000000) can0 123#"}) {
        EXPECT_EQ(parse_candump_line(line), std::nullopt) << line;
    }
}

TEST(Candump, accepts_lower_case_and_short_seconds) {
    const std::optional<LoggedFrame> read = parse_candump_line("(1.000002) vcan1 7ff#abCD");
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->time_us, 1'000'002U);
    EXPECT_EQ(read->interface_name, "vcan1");
    EXPECT_EQ(read->frame, make_frame(0x7FF, {0xAB, 0xCD}));
}

TEST(Candump, reads_times_with_nanoseconds) {
    const std::optional<LoggedFrame> read = parse_candump_line("(1436509052.249713999) can0 123#11");
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->time_us, 1'436'509'052'249'713U);
}

TEST(CandumpFile, is_read_whole) {
    const base::Result<Log> log = read_candump(
        "(1.000000) can0 123#11\n\n(2.000000) can1 705#R\r\n(3.000000) can0 00000123#2233 R\n"
        "(4.000000) can0 124# T",
        "run.log");
    ASSERT_TRUE(log.has_value()) << log.error().message;
    ASSERT_EQ(log->frames.size(), 4U);
    EXPECT_EQ(log->frames[0], (LoggedFrame{1'000'000, "can0", make_frame(0x123, {0x11})}));
    EXPECT_EQ(log->frames[1].interface_name, "can1");
    EXPECT_TRUE(log->frames[1].frame.remote);
    EXPECT_TRUE(log->frames[2].frame.extended);
    EXPECT_EQ(log->frames[3].frame, make_frame(0x124, {}));
    EXPECT_EQ(log->passed_over, 0U);
}

TEST(CandumpFile, passes_over_error_frames_and_fd_frames) {
    const base::Result<Log> log = read_candump(
        "(1.000000) can0 20000004#0010000000000000\n(2.000000) can0 123##1AABBCC\n"
        "(3.000000) can0 00000123##0\n(4.000000) can0 123#11\n",
        "run.log");
    ASSERT_TRUE(log.has_value()) << log.error().message;
    EXPECT_EQ(log->passed_over, 3U);
    EXPECT_EQ(log->frames.size(), 1U);
}

TEST(CandumpFile, is_refused_with_the_line_that_is_no_frame) {
    const std::string good = "(1.000000) can0 123#11\n";
    for (const std::string bad :
         {"hello", "(1.000000) can0 800#11", "(1.000000) can0 40000000#", "(1.000000) can0 20000004#0",
          "(1.000000) can0 123##", "(1.000000) can0 123##1A", "(1.000000) can0 123##1AG", "can0 123#11",
          "(1.000000) can0 123#11 R T"}) {
        const base::Result<Log> log = read_candump(good + "\n" + bad + "\n" + good, "run.log");
        ASSERT_FALSE(log.has_value()) << bad;
        EXPECT_EQ(log.error().message, "run.log:3: this is no frame as candump -L writes it");
    }
}

TEST(Candump, collects_a_log_of_lines) {
    CandumpLog log("can0");
    log.record(make_frame(0x705, {0}), 10);
    log.record(make_frame(0x000, {1, 5}), 20);
    EXPECT_EQ(log.frames(), 2U);
    EXPECT_EQ(std::string(log.content().begin(), log.content().end()),
              "(0000000000.000010) can0 705#00\n(0000000000.000020) can0 000#0105\n");
}

}  // namespace
}  // namespace cgw::media
