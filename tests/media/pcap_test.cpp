#include "media/pcap.hpp"

#include "sample_log.hpp"

namespace cgw::media {
namespace {

using test::make_frame;

std::string written(const std::vector<LoggedFrame>& frames) {
    const base::Result<base::Bytes> bytes = write_pcap(frames);
    return bytes ? std::string(bytes->begin(), bytes->end()) : bytes.error().message;
}

// Text of hexadecimal digits and blanks to bytes.
std::string bytes(std::string_view hexadecimal) {
    std::string digits;
    for (const char c : hexadecimal) {
        if (c != ' ') {
            digits += c;
        }
    }
    std::string result;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        result += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    }
    return result;
}

const std::string header = bytes("D4C3B2A1 0200 0400 00000000 00000000 00000400 E3000000");

std::string failure(const std::string& content) {
    const base::Result<Log> log = read_pcap(content, "run.pcap");
    return log ? "read" : log.error().message;
}

std::vector<LoggedFrame> frames(const std::string& content) {
    const base::Result<Log> log = read_pcap(content, "run.pcap");
    EXPECT_TRUE(log.has_value()) << log.error().message;
    return log ? log->frames : std::vector<LoggedFrame>{};
}

TEST(Pcap, writes_records_with_big_endian_identifiers) {
    frame::Frame extended = make_frame(0x12345, {0xAB});
    extended.extended = true;
    EXPECT_EQ(written({{2'000'003, "can0", make_frame(0x181, {0x11, 0x22})}, {4, "can1", extended}}),
              header + bytes("02000000 03000000 0A000000 0A000000 00000181 02000000 1122") +
                  bytes("00000000 04000000 09000000 09000000 80012345 01000000 AB"));
}

TEST(Pcap, writes_a_remote_frame_without_data) {
    frame::Frame remote;
    remote.id = 0x705;
    remote.remote = true;
    remote.length = 4;
    EXPECT_EQ(written({{0, "can0", remote}}),
              header + bytes("00000000 00000000 08000000 08000000 40000705 04000000"));
}

TEST(Pcap, writes_an_empty_log_as_a_header) {
    EXPECT_EQ(written({}), header);
    EXPECT_EQ(frames(header), std::vector<LoggedFrame>{});
}

TEST(Pcap, reads_what_it_writes) {
    EXPECT_EQ(frames(written(test::sample_log())), test::sample_log());
}

TEST(Pcap, refuses_to_write_a_time_that_the_format_has_not) {
    const base::Result<base::Bytes> bytes = write_pcap({{{4'294'967'296'000'000, "can0", {}}}});
    ASSERT_FALSE(bytes.has_value());
    EXPECT_EQ(bytes.error().message, "a pcap file has no times after the year 2106");
}

TEST(Pcap, reads_both_byte_orders_and_both_units_of_time) {
    const std::vector<LoggedFrame> expected = {{5'000'007, "can0", make_frame(0x181, {0x11})}};
    const std::string frame = bytes("00000181 01000000 11");
    EXPECT_EQ(frames(header + bytes("05000000 07000000 09000000 09000000") + frame), expected);
    EXPECT_EQ(frames(bytes("4D3CB2A1 0200 0400 00000000 00000000 00000400 E3000000") +
                     bytes("05000000 571D0000 09000000 09000000") + frame),
              expected);
    EXPECT_EQ(frames(bytes("A1B2C3D4 0002 0004 00000000 00000000 00040000 000000E3") +
                     bytes("00000005 00000007 00000009 00000009") + frame),
              expected);
    EXPECT_EQ(frames(bytes("A1B23C4D 0002 0004 00000000 00000000 00040000 000000E3") +
                     bytes("00000005 00001D57 00000009 00000009") + frame),
              expected);
}

TEST(Pcap, reads_records_of_the_kernels_full_length) {
    EXPECT_EQ(
        frames(header + bytes("00000000 00000000 10000000 10000000 00000181 01000000 1100000000000000")),
        (std::vector<LoggedFrame>{{0, "can0", make_frame(0x181, {0x11})}}));
}

TEST(Pcap, passes_over_error_frames_and_fd_frames) {
    const std::string content =
        header + bytes("00000000 00000000 10000000 10000000 20000040 08000000 0000000000000000") +
        bytes("00000000 00000000 0C000000 0C000000 00000181 0C000000 11223344") +
        bytes("00000000 00000000 09000000 09000000 00000181 01040000 11") +
        bytes("00000000 00000000 09000000 09000000 00000181 01000000 11");
    const base::Result<Log> log = read_pcap(content, "run.pcap");
    ASSERT_TRUE(log.has_value());
    EXPECT_EQ(log->passed_over, 3U);
    EXPECT_EQ(log->frames.size(), 1U);
}

TEST(Pcap, refuses_what_is_no_pcap_file_of_can) {
    EXPECT_EQ(failure(""), "run.pcap: this is no pcap file");
    EXPECT_EQ(failure("(0.000000) can0 123#"), "run.pcap: this is no pcap file");
    EXPECT_EQ(failure(bytes("0A0D0D0A 1C000000")),
              "run.pcap: this is a pcapng file; save it as pcap (editcap -F pcap)");
    EXPECT_EQ(failure(bytes("D4C3B2A1 0200 0400 00000000 00000000 00000400 01000000")),
              "run.pcap: link type 1 is not CAN; CAN is 227");
}

TEST(Pcap, refuses_a_file_that_is_cut_off) {
    const std::string whole = written(test::sample_log());
    for (std::size_t size = 4; size < 24; ++size) {
        EXPECT_EQ(failure(whole.substr(0, size)), "run.pcap: the file is cut off in its header");
    }
    for (std::size_t size = 25; size < 24 + 16 + 10; ++size) {
        EXPECT_EQ(failure(whole.substr(0, size)), "run.pcap: record 1: the file is cut off") << size;
    }
    EXPECT_EQ(failure(whole.substr(0, whole.size() - 1)), "run.pcap: record 6: the file is cut off");
}

TEST(Pcap, refuses_a_record_that_contradicts_itself) {
    const auto record = [](std::string_view hexadecimal) { return failure(header + bytes(hexadecimal)); };
    EXPECT_EQ(record("00000000 00000000 FFFFFFFF FFFFFFFF 00000181 01000000 11"),
              "run.pcap: record 1: its length is not possible");
    EXPECT_EQ(record("00000000 40420F00 09000000 09000000 00000181 01000000 11"),
              "run.pcap: record 1: its time is not possible");
    EXPECT_EQ(record("00000000 00000000 07000000 07000000 00000181 010000"),
              "run.pcap: record 1: it holds no CAN frame");
    EXPECT_EQ(record("00000000 00000000 09000000 10000000 00000181 02000000 11"),
              "run.pcap: record 1: it holds no CAN frame");
    EXPECT_EQ(record("00000000 00000000 09000000 09000000 00000800 01000000 11"),
              "run.pcap: record 1: it holds no CAN frame");
}

TEST(Pcap, is_told_by_its_first_bytes) {
    EXPECT_TRUE(is_pcap(header));
    EXPECT_TRUE(is_pcap(bytes("A1B23C4D")));
    EXPECT_TRUE(is_pcap(bytes("0A0D0D0A")));
    EXPECT_FALSE(is_pcap(bytes("D4C3B2")));
    EXPECT_FALSE(is_pcap("(0000000000.000000) can0 123#"));
}

}  // namespace
}  // namespace cgw::media
