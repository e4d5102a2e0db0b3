#include "media/slcan_line.hpp"

#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using test::make_frame;

frame::Frame extended(frame::Frame frame) {
    frame.extended = true;
    return frame;
}
frame::Frame remote(std::uint32_t id, std::uint8_t length) {
    frame::Frame frame;
    frame.id = id;
    frame.length = length;
    frame.remote = true;
    return frame;
}

// Everything the reader says to `text`: frames as lines, ok, no, damaged.
std::vector<std::string> read(SlcanReader& reader, std::string_view text) {
    std::vector<std::string> said;
    for (const char character : text) {
        const std::optional<SlcanEvent> event = reader.take(character);
        if (!event) {
            continue;
        }
        switch (event->answer) {
            case SlcanAnswer::frame:
                said.push_back(slcan_line(event->frame));
                break;
            case SlcanAnswer::damaged:
                said.emplace_back("damaged");
                break;
            case SlcanAnswer::accepted:
                said.emplace_back("ok");
                break;
            case SlcanAnswer::refused:
                said.emplace_back("no");
                break;
        }
    }
    return said;
}

using Said = std::vector<std::string>;

TEST(SlcanLine, writes_the_four_kinds_of_frames) {
    EXPECT_EQ(slcan_line(make_frame(0x123, {0x11, 0xA2})), "t123211A2\r");
    EXPECT_EQ(slcan_line(make_frame(0, {})), "t0000\r");
    EXPECT_EQ(slcan_line(extended(make_frame(0x1ABCDEF0, {1}))), "T1ABCDEF0101\r");
    EXPECT_EQ(slcan_line(remote(0x705, 0)), "r7050\r");
    EXPECT_EQ(slcan_line(extended(remote(0x705, 8))), "R000007058\r");
}

TEST(SlcanLine, reads_what_it_writes) {
    for (const frame::Frame& frame :
         {make_frame(0x7FF, {1, 2, 3, 4, 5, 6, 7, 8}), make_frame(0, {}),
          extended(make_frame(0x1FFFFFFF, {9})), remote(0x705, 4), extended(remote(1, 0))}) {
        std::string line = slcan_line(frame);
        line.pop_back();
        EXPECT_EQ(parse_slcan_line(line), frame) << line;
    }
}

TEST(SlcanLine, accepts_lower_case_and_a_time_stamp) {
    EXPECT_EQ(parse_slcan_line("t1232ab0cEA5f"), make_frame(0x123, {0xAB, 0x0C}));
    EXPECT_EQ(parse_slcan_line("r12320000"), remote(0x123, 2));
}

TEST(SlcanLine, refuses_every_other_line) {
    for (const char* line : {"",
                             "t",
                             "t12",
                             "t1239",
                             "t8000",
                             "t123",
                             "t12321",
                             "t123211",
                             "t1232112",
                             "t12321122334",
                             "t1232112233445",
                             "t123211G2",
                             "t1232-1-2",
                             "T12301122",
                             "T200000000",
                             "TFFFFFFFF0",
                             "r",
                             "r123",
                             "r1239",
                             "r12321",
                             "R1230",
                             "x1230",
                             "S6",
                             "V1013",
                             " t1230",
                             "t-120",
                             "t 1230"}) {
        EXPECT_EQ(parse_slcan_line(line), std::nullopt) << line;
    }
}

TEST(SlcanLine, has_a_command_for_nine_bit_rates) {
    std::string all;
    for (const unsigned kbit : {10U, 20U, 50U, 100U, 125U, 250U, 500U, 800U, 1000U}) {
        all += slcan_bit_rate_command(kbit).value_or("?");
    }
    EXPECT_EQ(all, "S0S1S2S3S4S5S6S7S8");
    EXPECT_EQ(slcan_bit_rate_command(0), std::nullopt);
    EXPECT_EQ(slcan_bit_rate_command(83), std::nullopt);
}

TEST(SlcanReader, reads_lines_however_they_come) {
    SlcanReader reader;
    EXPECT_EQ(read(reader, "t12"), Said{});
    EXPECT_EQ(read(reader, "3211"), Said{});
    EXPECT_EQ(read(reader, "A2\rt7050\rT0000"), (Said{"t123211A2\r", "t7050\r"}));
    EXPECT_EQ(read(reader, "12340\r"), Said{"T000012340\r"});
}

TEST(SlcanReader, reads_answers) {
    SlcanReader reader;
    EXPECT_EQ(read(reader, "\r\a\rz\rZ\r"), (Said{"ok", "no", "ok", "ok", "ok"}));
    EXPECT_EQ(read(reader, "V1013\rNA123\rF00\r"), Said{});
}

TEST(SlcanReader, does_not_mind_line_feeds) {
    SlcanReader reader;
    EXPECT_EQ(read(reader, "t7050\r\nt7060\r\n"), (Said{"t7050\r", "t7060\r"}));
}

TEST(SlcanReader, finds_its_way_back_after_junk) {
    SlcanReader reader;
    EXPECT_EQ(read(reader, std::string("\0\xFF junk\r", 8)), Said{});
    EXPECT_EQ(read(reader, "23211A2\rt123\rt7050\r"), (Said{"damaged", "t7050\r"}));
    EXPECT_EQ(read(reader, "t7\at7050\r"), (Said{"no", "t7050\r"}));
}

TEST(SlcanReader, keeps_no_more_of_a_line_than_the_longest_frame_has) {
    SlcanReader reader;
    EXPECT_EQ(read(reader, "t7050" + std::string(100'000, '0')), Said{});
    EXPECT_EQ(read(reader, "\rt7060\r"), (Said{"damaged", "t7060\r"}));
    EXPECT_EQ(read(reader, std::string(100'000, 'x') + "\rt7070\r"), Said{"t7070\r"});
}

TEST(SlcanReader, forgets_the_line_it_is_in_when_cleared) {
    SlcanReader reader;
    read(reader, "t70");
    reader.clear();
    EXPECT_EQ(read(reader, "t7050\r"), Said{"t7050\r"});
}

}  // namespace
}  // namespace cgw::media
