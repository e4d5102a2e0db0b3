#include "media/socketcand.hpp"

#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using cgw::test::make_frame;
using Item = MessageStream::Item;

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

// Everything a stream holds, in brackets; '!' for junk, '#' for a message that is too long.
std::string items(MessageStream& stream) {
    std::string all;
    std::string_view text;
    for (;;) {
        switch (stream.next(text)) {
            case Item::none:
                return all;
            case Item::message:
                all += "[" + std::string(text) + "]";
                break;
            case Item::junk:
                all += "!";
                break;
            case Item::too_long:
                return all + "#";
        }
    }
}

TEST(MessageStream, gives_the_same_messages_wherever_the_stream_is_cut) {
    const std::string whole = "< hi >< open can0 >\n< send 123 2 1 f1 > \r\n<echo>x y<>z< a < b >";
    const std::string expected = "[hi][open can0][send 123 2 1 f1][echo]![]![a < b]";
    for (std::size_t first = 0; first <= whole.size(); ++first) {
        for (std::size_t second = first; second <= whole.size(); ++second) {
            MessageStream stream;
            std::string found;
            for (const std::string& part :
                 {whole.substr(0, first), whole.substr(first, second - first), whole.substr(second)}) {
                stream.append(part);
                found += items(stream);
            }
            ASSERT_EQ(found, expected) << first << ' ' << second;
        }
    }
}

TEST(MessageStream, takes_the_longest_message_and_no_longer_one) {
    const std::string longest = "<" + std::string(MessageStream::longest - 2, 'a') + ">";
    MessageStream stream;
    stream.append(longest);
    EXPECT_EQ(items(stream), "[" + longest.substr(1, longest.size() - 2) + "]");
    stream.append("<a" + longest.substr(1));
    EXPECT_EQ(items(stream), "#");
    EXPECT_EQ(items(stream), "#");  // and stays there
}

TEST(MessageStream, gives_up_a_message_without_end_before_it_has_come) {
    MessageStream stream;
    stream.append("<" + std::string(MessageStream::longest - 2, 'a'));
    EXPECT_EQ(items(stream), "");
    stream.append("a");
    EXPECT_EQ(items(stream), "#");
}

TEST(Socketcand, words_end_at_blanks) {
    std::string_view text = "  send \t 123 ";
    EXPECT_EQ(next_word(text), "send");
    EXPECT_EQ(text, "123");
    EXPECT_EQ(next_word(text), "123");
    EXPECT_EQ(next_word(text), "");
}

TEST(Socketcand, writes_what_socketcand_writes) {
    EXPECT_EQ(send_message(make_frame(0x123, {0x01, 0xF1})), "< send 123 2 01 F1 >");
    EXPECT_EQ(send_message(make_frame(0, {})), "< send 000 0 >");
    EXPECT_EQ(send_message(extended(make_frame(0x12, {0xA}))), "< send 00000012 1 0A >");
    EXPECT_EQ(send_message(remote(0x705, 8)), "< sendrtr 705 8 >");
    EXPECT_EQ(frame_message(make_frame(0x123, {0x1A, 0x22}), 23'424'242), "\n< frame 123 23.424242 1A22 >");
    EXPECT_EQ(frame_message(make_frame(0x7, {}), 7), "\n< frame 007 0.000007  >");
    EXPECT_EQ(frame_message(extended(make_frame(0x123, {1})), 1'000'000), "\n< frame 00000123 1.000000 01 >");
    EXPECT_EQ(frame_message(remote(0x705, 4), 1), "\n< rtr 705 0.000001 4 >");
}

TEST(Socketcand, reads_back_every_frame_it_writes) {
    frame::Frame remote_extended = extended(remote(0x1FFFFFFF, 3));
    for (const frame::Frame& frame :
         {make_frame(0, {}), make_frame(0x7FF, {1, 2, 3, 4, 5, 6, 7, 8}), extended(make_frame(0x7FF, {0xFF})),
          extended(make_frame(0x1FFFFFFF, {0, 0})), remote(0x123, 0), remote_extended}) {
        const std::string sent = send_message(frame);
        const std::string words = sent.substr(sent.find(' ', 2), sent.size() - 1 - sent.find(' ', 2));
        const auto back = frame.remote ? parse_sendrtr(words) : parse_send(words);
        ASSERT_TRUE(back) << sent;
        EXPECT_EQ(*back, frame) << sent;
        const std::string received = frame_message(frame, 1'234'567);
        const std::string rest =
            received.substr(received.find(' ', 3), received.size() - 2 - received.find(' ', 3));
        EXPECT_EQ(frame.remote ? parse_rtr(rest) : parse_frame(rest), frame) << received;
    }
}

TEST(Socketcand, takes_identifiers_as_python_can_writes_them) {
    EXPECT_EQ(*parse_send("1 0 "), make_frame(1, {}));
    EXPECT_EQ(*parse_send("0012 1 a"), make_frame(0x12, {0xA}));
    EXPECT_EQ(*parse_send("ABCDE 0"), extended(make_frame(0xABCDE, {})));
}

TEST(Socketcand, takes_frames_whose_bytes_stand_apart) {
    EXPECT_EQ(parse_frame("123 23.424242 11 22 3"), make_frame(0x123, {0x11, 0x22, 0x3}));
    EXPECT_EQ(parse_frame("123 23.424242 1122 33"), make_frame(0x123, {0x11, 0x22, 0x33}));
}

TEST(Socketcand, refuses_wrong_frames_of_clients) {
    for (const char* words : {"", "123", "x 0", "-1 0", "0x1 0", "20000000 0", "123456789 0", "123 9",
                              "123 -1", "123 1", "123 08", "123 2 1", "123 1 100", "123 1 g", "123 1 -1",
                              "123 1 +1", "123 1 1 2", "123 0 1", "123 8 1 2 3 4 5 6 7 8 9"}) {
        EXPECT_FALSE(parse_send(words)) << words;
    }
    for (const char* words : {"", "123", "123 9", "123 1 0", "20000000 0"}) {
        EXPECT_FALSE(parse_sendrtr(words)) << words;
    }
    EXPECT_EQ(parse_send("123 2 1").error().message, "byte 2 of 2 is missing or wrong: ''");
    EXPECT_EQ(parse_send("800x 2").error().message, "no identifier of a frame: '800x'");
    EXPECT_EQ(parse_send("123 9").error().message, "no length 0..8: '9'");
    EXPECT_EQ(parse_send("123 0 1").error().message, "more follows than 0 bytes of data");
}

TEST(Socketcand, refuses_wrong_frames_of_hubs) {
    for (const char* words : {"", "123", "123 x 11", "x 1.0 11", "123 1.0 111", "123 1.0 1g",
                              "123 1.0 112233445566778899", "123 1.0 1122334455667788 99"}) {
        EXPECT_FALSE(parse_frame(words)) << words;
    }
    for (const char* words : {"123 1.0", "123 1.0 9", "123 1.0 1 1", "123 x 1"}) {
        EXPECT_FALSE(parse_rtr(words)) << words;
    }
}

TEST(Socketcand, tells_how_many_frames_were_lost) {
    const std::string message = lost_message(1234);
    EXPECT_EQ(message, "\n< error 1234 frames lost, this client is too slow >");
    EXPECT_EQ(parse_lost(message.substr(9, message.size() - 11)), 1234U);
    EXPECT_FALSE(parse_lost("unknown message"));
    EXPECT_FALSE(parse_lost("x frames lost, this client is too slow"));
    EXPECT_FALSE(parse_lost(""));
}

TEST(Socketcand, an_error_cannot_end_early_or_grow) {
    EXPECT_EQ(error_message("a <b> \x1b[31m"), "< error a ?b? ?[31m >");
    EXPECT_LE(error_message(std::string(1000, 'x')).size(), MessageStream::longest);
}

TEST(Socketcand, knows_names_of_buses) {
    for (const char* name : {"can0", "a", "CAN_1.b-c", "0123456789abcdef"}) {
        EXPECT_TRUE(is_bus_name(name)) << name;
    }
    for (const char* name : {"", "0123456789abcdefg", "can 0", "can/0", "<", "\xC3\xA4"}) {
        EXPECT_FALSE(is_bus_name(name)) << name;
    }
}

}  // namespace
}  // namespace cgw::media
