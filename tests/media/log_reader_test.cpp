// Logs read piece by piece: every form, any cut, and what is no log.
#include "media/log_reader.hpp"

#include <random>

#include "media/candump_screen.hpp"
#include "media/log.hpp"
#include "sample_log.hpp"

namespace cgw::media {
namespace {

using Kind = LogReader::Kind;

struct Collected {
    std::vector<LoggedFrame> frames;
    std::vector<std::string> faults;  // "3: why"
    std::size_t passed_over = 0;
    bool timed = true;
};

// Fed in pieces of that many bytes.
Collected read_in_pieces(std::string_view content, std::size_t piece) {
    LogReader reader;
    Collected all;
    for (;;) {
        const LogReader::Item& item = reader.next();
        switch (item.kind) {
            case Kind::frame:
                all.frames.push_back(item.logged);
                all.timed = all.timed && item.has_time;
                break;
            case Kind::fault:
                all.faults.push_back(std::to_string(item.number) + ": " + item.fault);
                break;
            case Kind::passed_over:
                ++all.passed_over;
                break;
            case Kind::blank:
                break;
            case Kind::hungry:
                if (content.empty()) {
                    reader.finish();
                }
                reader.feed(content.substr(0, piece));
                content.remove_prefix(std::min(piece, content.size()));
                break;
            case Kind::end:
                return all;
        }
    }
}

std::string written(LogFormat format) {
    const auto bytes = write_log(format, test::sample_log());
    return {bytes->begin(), bytes->end()};
}

std::string line_of_screen(const std::string& line) {
    const ScreenLine read = read_screen_line(line);
    if (read.line.kind != LineKind::frame) {
        return read.line.kind == LineKind::passed_over ? "passed over" : "wrong";
    }
    return (read.has_time ? "" : "no time: ") + candump_line(read.line.logged);
}

}  // namespace

TEST(LogReader, reads_what_is_written_in_pieces_of_any_size) {
    for (const LogFormat format : {LogFormat::candump, LogFormat::pcap}) {
        for (const std::size_t piece : {1U, 2U, 7U, 16U, 100U, 100'000U}) {
            const Collected all = read_in_pieces(written(format), piece);
            EXPECT_EQ(all.frames, test::sample_log()) << piece;
            EXPECT_TRUE(all.faults.empty());
        }
    }
}

TEST(LogReader, goes_on_behind_a_line_that_is_no_frame) {
    const Collected all = read_in_pieces(
        "(1.000000) can0 123#11\nhello\n\n(2.000000) can0 123##1AA\r\n(3.000000) can0 123#22", 5);
    EXPECT_EQ(all.frames.size(), 2U);
    EXPECT_EQ(all.passed_over, 1U);
    EXPECT_EQ(all.faults, (std::vector<std::string>{"2: this is no frame as candump writes it"}));
}

TEST(LogReader, takes_an_empty_file) {
    for (const char* const text : {"", "\n", "(", "\n\n\r\n"}) {
        EXPECT_TRUE(read_in_pieces(text, 1).frames.empty());
    }
}

TEST(LogReader, tells_a_giant_line_once_and_does_not_keep_it) {
    const std::string line(10'000'000, 'x');
    const Collected all = read_in_pieces(line + "\n(3.000000) can0 123#22\n" + line, 65'536);
    EXPECT_EQ(all.frames.size(), 1U);
    EXPECT_EQ(all.faults, (std::vector<std::string>{"1: a line of more than 4096 bytes is no frame",
                                                    "3: a line of more than 4096 bytes is no frame"}));
}

TEST(LogReader, ends_where_a_pcap_file_makes_no_sense_any_more) {
    const std::string good = written(LogFormat::pcap);
    std::string length = good;
    length[24 + 8 + 3] = '\x7F';
    EXPECT_EQ(read_in_pieces(length, 10).faults,
              (std::vector<std::string>{
                  "1: the length of this record is not possible, and what follows cannot be found"}));
    for (std::size_t size = 24; size < good.size(); ++size) {
        const Collected all = read_in_pieces(std::string_view(good).substr(0, size), 11);
        EXPECT_LE(all.faults.size(), 1U);
        EXPECT_LT(all.frames.size(), test::sample_log().size());
    }
    EXPECT_EQ(read_in_pieces(good.substr(0, 20), 3).faults,
              (std::vector<std::string>{"0: the file is cut off in its header"}));
    EXPECT_EQ(read_in_pieces("\x0A\x0D\x0D\x0A....................", 3).faults,
              (std::vector<std::string>{"0: this is a pcapng file; save it as pcap (editcap -F pcap)"}));
}

TEST(LogReader, goes_on_behind_a_record_with_an_impossible_time) {
    std::string log = written(LogFormat::pcap);
    log[24 + 4 + 3] = '\x7F';  // microseconds of the first record
    const Collected all = read_in_pieces(log, 64);
    EXPECT_EQ(all.faults, (std::vector<std::string>{"1: the time of this record is not possible"}));
    EXPECT_EQ(all.frames.size(), test::sample_log().size() - 1);
}

TEST(LogReader, survives_any_bytes) {
    std::mt19937 random(5);
    const std::string logs[] = {written(LogFormat::candump), written(LogFormat::pcap)};
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = logs[static_cast<std::size_t>(round % 2)];
        for (int change = 0; change < 4; ++change) {
            bytes[random() % bytes.size()] = static_cast<char>(static_cast<unsigned char>(random() & 0xFFU));
        }
        const Collected whole = read_in_pieces(bytes, bytes.size());
        const Collected pieces = read_in_pieces(bytes, 1 + random() % 40);
        ASSERT_EQ(whole.frames, pieces.frames);
        ASSERT_EQ(whole.faults, pieces.faults);
    }
}

TEST(CandumpScreen, is_read_with_all_options_of_time_and_direction) {
    const std::string bytes = "can0  123   [2]  11 A2";
    EXPECT_EQ(line_of_screen("  " + bytes), "no time: (0000000000.000000) can0 123#11A2");
    EXPECT_EQ(line_of_screen(" (1436509052.249713)  " + bytes), "(1436509052.249713) can0 123#11A2");
    EXPECT_EQ(line_of_screen(" (1436509052.249713001)  " + bytes), "(1436509052.249713) can0 123#11A2");
    EXPECT_EQ(line_of_screen(" (2015-07-10 06:17:32.249713)  " + bytes), "(1436509052.249713) can0 123#11A2");
    EXPECT_EQ(line_of_screen(" (000.000123)  can0  RX - -  123   [2]  11 A2"),
              "(0000000000.000123) can0 123#11A2");
    EXPECT_EQ(line_of_screen("  can0  123   [2]  41 42   'AB'"),
              "no time: (0000000000.000000) can0 123#4142");
    EXPECT_EQ(line_of_screen("  can0  705   [0]  remote request"), "no time: (0000000000.000000) can0 705#R");
    EXPECT_EQ(line_of_screen("  can0  1ABCDEF0   [1]  01"), "no time: (0000000000.000000) can0 1ABCDEF0#01");
}

TEST(CandumpScreen, passes_error_and_fd_frames_over) {
    EXPECT_EQ(line_of_screen("  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME"), "passed over");
    EXPECT_EQ(line_of_screen("  can0  123  [12]  11 22 33 44 55 66 77 88 99 AA BB CC"), "passed over");
}

TEST(CandumpScreen, refuses_every_other_line) {
    for (const char* const line :
         {"", "can0", "can0  123", "can0  123   [2]", "can0  123   [2]  11", "can0  123   [2]  11 22 33",
          "can0  123   [9]  11", "can0  800   [0]", "can0  12   [0]", "can0  123   [2]  1 22",
          "(1.5)  can0  123   [0]", "(x.000000)  can0  123   [0]",
          "(2015-13-10 06:17:32.249713)  can0  123   [0]", "(2015-07-10 25:17:32.249713)  can0  123   [0]",
          "(1.000000  can0  123   [0]"}) {
        EXPECT_EQ(line_of_screen(line), "wrong") << line;
    }
}

}  // namespace cgw::media
