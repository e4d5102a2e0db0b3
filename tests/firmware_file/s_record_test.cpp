#include "firmware_file/s_record.hpp"

#include <gtest/gtest.h>

#include "text.hpp"

namespace cgw::firmware_file {
namespace {

using test::refusal;
using test::replaced;

const std::string good =
    "S00600004844521B\n"
    "S315080000F0000102030405060708090A0B0C0D0E0F7A\n"
    "S3090800010010111213A7\n"
    "S5030002FA\n"
    "S705080000ED05\n";

Outcome<SRecord> read(const std::string& text) {
    return read_s_record(base::to_bytes(text));
}

TEST(SRecordFile, is_read_and_written_back_the_same) {
    const Outcome<SRecord> file = read(good);
    ASSERT_EQ(refusal(file), "");
    ASSERT_EQ(file->memory.blocks().size(), 1U);
    EXPECT_EQ(file->memory.blocks()[0].address, 0x080000F0U);
    EXPECT_EQ(file->memory.blocks()[0].bytes.size(), 20U);
    EXPECT_EQ(file->headers, (std::vector<SRecordHeader>{{0, base::to_bytes("HDR")}}));
    EXPECT_EQ(file->start, 0x080000EDU);
    EXPECT_EQ(write_s_record(*file), good);
}

TEST(SRecordFile, keeps_the_width_of_its_addresses_until_they_need_more) {
    Outcome<SRecord> file = read("S1050010AABB85\r\nS9030000FC\r\n");
    ASSERT_EQ(refusal(file), "");
    EXPECT_EQ(write_s_record(*file), "S1050010AABB85\r\nS9030000FC\r\n");
    file->memory.put(0x10000, base::Bytes{1});
    EXPECT_EQ(write_s_record(*file), "S206000010AABB84\r\nS20501000001F8\r\nS804000000FB\r\n");
    file->memory.put(0xFFFFFFFF, base::Bytes{1});
    EXPECT_EQ(write_s_record(*file).substr(0, 4), "S307");
}

TEST(SRecordFile, keeps_all_its_headers_also_empty_ones_and_those_with_an_address) {
    const std::string text = "S0030000FC\nS00600004844521B\nS00412344174\nS1050010AABB85\nS9030000FC\n";
    const Outcome<SRecord> file = read(text);
    ASSERT_EQ(refusal(file), "");
    EXPECT_EQ(file->headers, (std::vector<SRecordHeader>{
                                 {0, {}}, {0, base::to_bytes("HDR")}, {0x1234, base::to_bytes("A")}}));
    EXPECT_EQ(write_s_record(*file), text);
}

TEST(SRecordFile, tells_what_it_has_beside_its_data) {
    const auto others = [](const std::string& text) { return other_s_records(base::to_bytes(text)); };
    EXPECT_EQ(others(good), (std::vector<std::string>{"S00600004844521B", "count", "start 80000ED"}));
    EXPECT_EQ(others("S0030000fc\r\nS0030000FC \nS9031234B6\n\x1A"),
              (std::vector<std::string>{"S0030000FC", "S0030000FC", "start 1234"}));
    EXPECT_EQ(others("S70500001234B4"), others("S9031234B6"));
    EXPECT_NE(others("S9031234B6"), others("S9031235B5"));
    EXPECT_EQ(others("S9030000FC"), std::vector<std::string>{"start "});
}

TEST(SRecordFile, is_cut_at_multiples_of_its_record_length) {
    SRecord file;
    file.style.data_bytes = 4;
    file.memory = Memory(0x1003, base::Bytes{1, 2, 3, 4, 5, 6});
    EXPECT_EQ(write_s_record(file), "S104100301E7\nS107100402030405D6\nS104100806DD\nS9030000FC\n");
}

// Where no block has room for a full record between two multiples, shorter ones are the full ones.
TEST(SRecordFile, is_cut_the_same_when_it_is_read_again) {
    for (std::size_t bytes = 1; bytes <= 40; ++bytes) {
        for (std::uint64_t address = 0x100; address <= 0x110; ++address) {
            for (std::size_t most = 1; most <= 33; ++most) {
                SRecord file;
                file.style.data_bytes = most;
                file.memory.put(address, base::Bytes(bytes, 0x4B));
                const std::string written = write_s_record(file);
                const Outcome<SRecord> again = read(written);
                ASSERT_EQ(refusal(again), "");
                ASSERT_EQ(write_s_record(*again), written) << address << ' ' << bytes << ' ' << most;
            }
        }
    }
}

TEST(SRecordFile, may_end_like_a_text_of_dos) {
    EXPECT_EQ(refusal(read(good + "\x1A\x1A")), "");
    EXPECT_EQ(refusal(read(good + "\x1A" + "S5030002FA")),
              "6:1-12 record-end: something follows the end record");
}

TEST(SRecordFile, is_refused_at_the_place_of_its_fault) {
    const auto with = [](const std::string& old, const std::string& text) {
        return refusal(read(replaced(good, old, text)));
    };
    EXPECT_EQ(with("0E0F7A", "0E0F7B"), "2:45-47 record-checksum: the checksum is 7B, the bytes give 7A");
    EXPECT_EQ(with("S309", "S308"), "3:1-23 record-line: the record says that 8 bytes follow, and has 9");
    EXPECT_EQ(with("S309", "S409"), "3:1-3 record-line: there are no S4 records");
    EXPECT_EQ(with("S309", "T309"), "3:1-23 record-line: a record begins with S0 to S9");
    EXPECT_EQ(with("S309", "S30X"), "3:4-5 record-line: 'X' is no hexadecimal digit");
    EXPECT_EQ(with("S3090800010010111213A7", "S3"), "3:1-3 record-line: the record has no length");
    EXPECT_EQ(with("S3090800010010111213A7", "S304080001F2"),
              "3:1-13 record-line: the record is too short for its address and checksum");
    EXPECT_EQ(with("S3090800010010111213A7", "S309080000F210111213B6"),
              "3:1-23 record-address: address 0x080000F2 is given again; line 2 has it already");
    EXPECT_EQ(with("S3090800010010111213A7", "S105FFFFAABB97"),
              "3:5-9 record-address: the record runs over the highest address it can have");
    EXPECT_EQ(with("S5030002FA", "S5030003F9"),
              "4:1-11 record-end: this counts 3 data records, the file has 2");
    EXPECT_EQ(with("S5030002FA", "S5040002AA4F"), "4:1-13 record-line: this kind of record has no data");
    EXPECT_EQ(with("S705080000ED05\n", ""),
              "4:1-1 record-end: the file ends without an end record (S7, S8 or S9): it is not whole");
    EXPECT_EQ(with("S705080000ED05\n", "S705080000ED05\nS5030002FA\n"),
              "6:1-11 record-end: something follows the end record");
}

// The digit behind the S is in no checksum; files that mix widths of addresses are common.
TEST(SRecordFile, never_loses_or_changes_data_when_it_was_cut_or_another_digit_changed) {
    const Memory memory = read(good)->memory;
    for (std::size_t size = 0; size + 1 < good.size(); ++size) {
        EXPECT_NE(refusal(read(good.substr(0, size))), "") << size;
    }
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        const std::string damaged = test::flipped(good, bit);
        const Outcome<SRecord> file = read(damaged);
        const bool is_type = bit >= 8 && good[bit / 8 - 1] == 'S';
        EXPECT_TRUE(!file || file->memory == memory || is_type) << damaged;
    }
}

}  // namespace
}  // namespace cgw::firmware_file
