#include "firmware_file/intel_hex.hpp"

#include <gtest/gtest.h>

#include "text.hpp"

namespace cgw::firmware_file {
namespace {

using test::refusal;
using test::replaced;

const std::string good =
    ":020000040800F2\n"
    ":10FFF000000102030405060708090A0B0C0D0E0F89\n"
    ":020000040801F1\n"
    ":0400000010111213B6\n"
    ":04000005080000ED02\n"
    ":00000001FF\n";

Outcome<IntelHex> read(const std::string& text) {
    return read_intel_hex(base::to_bytes(text));
}

// Where no block has room for a full record between two multiples, shorter ones are the full ones.
TEST(IntelHexFile, is_cut_the_same_when_it_is_read_again) {
    for (std::size_t bytes = 1; bytes <= 40; ++bytes) {
        for (std::uint64_t address = 0xFFF0; address <= 0x10000; ++address) {
            for (std::size_t most = 1; most <= 33; ++most) {
                IntelHex file;
                file.style.data_bytes = most;
                file.memory.put(address, base::Bytes(bytes, 0x4B));
                const std::string written = write_intel_hex(file);
                const Outcome<IntelHex> again = read(written);
                ASSERT_EQ(refusal(again), "");
                ASSERT_EQ(write_intel_hex(*again), written) << address << ' ' << bytes << ' ' << most;
            }
        }
    }
}

TEST(IntelHexFile, is_read_and_written_back_the_same) {
    const Outcome<IntelHex> file = read(good);
    ASSERT_EQ(refusal(file), "");
    ASSERT_EQ(file->memory.blocks().size(), 1U);
    EXPECT_EQ(file->memory.blocks()[0].address, 0x0800FFF0U);
    EXPECT_EQ(file->memory.blocks()[0].bytes.size(), 20U);
    EXPECT_EQ(file->memory.blocks()[0].bytes[19], 0x13);
    EXPECT_EQ(file->start_linear.value().start, 0x080000EDU);
    EXPECT_EQ(write_intel_hex(*file), good);
}

TEST(IntelHexFile, is_written_in_ascending_order_with_its_line_ends_and_record_length) {
    const Outcome<IntelHex> file = read(
        ":020000021000EC\r\n:080010000000000000000000E8\r\n:0200000000FFFF\r\n:040000031000F0006 9\r\n"
        ":00000001FF\r\n");
    EXPECT_EQ(refusal(file), "4:19-20 record-line: ' ' is no hexadecimal digit");
    const Outcome<IntelHex> mended = read(
        ":020000021000EC\r\n:080010000000000000000000E8\r\n\r\n:0200000000ffff  \r\n:040000031000F000F9\r\n"
        ":00000001FF\r\n");
    ASSERT_EQ(refusal(mended), "");
    EXPECT_TRUE(mended->segmented);
    EXPECT_EQ(write_intel_hex(*mended),
              ":020000021000EC\r\n:0200000000FFFF\r\n:080010000000000000000000E8\r\n:040000031000F000F9\r\n"
              ":00000001FF\r\n");
}

TEST(IntelHexFile, goes_over_to_linear_addresses_beyond_the_reach_of_segments) {
    IntelHex file;
    file.segmented = true;
    file.memory = Memory(0xFFFFE, base::Bytes{1, 2});
    EXPECT_EQ(write_intel_hex(file), ":02000002F0000C\n:02FFFE000102FE\n:00000001FF\n");
    file.memory = Memory(0xFFFFE, base::Bytes{1, 2, 3});
    EXPECT_EQ(write_intel_hex(file),
              ":02000004000FEB\n:02FFFE000102FE\n:020000040010EA\n:0100000003FC\n:00000001FF\n");
}

TEST(IntelHexFile, keeps_the_start_address_in_its_end_record) {
    const Outcome<IntelHex> file = read(":0100000055AA\n:00010001FE\n");
    ASSERT_EQ(refusal(file), "");
    EXPECT_EQ(file->end_address, 0x100);
    EXPECT_EQ(write_intel_hex(*file), ":0100000055AA\n:00010001FE\n");
}

TEST(IntelHexFile, keeps_the_address_field_of_start_records) {
    const std::string text = ":0100000055AA\n:0400020312340005AC\n:04001005080000EDF2\n:00000001FF\n";
    const Outcome<IntelHex> file = read(text);
    ASSERT_EQ(refusal(file), "");
    EXPECT_EQ(write_intel_hex(*file), text);
}

TEST(IntelHexFile, tells_what_it_has_beside_its_data) {
    const auto others = [](const std::string& text) { return other_intel_hex_records(base::to_bytes(text)); };
    EXPECT_EQ(others(good), (std::vector<std::string>{":00000001FF", ":04000005080000ED02"}));
    EXPECT_EQ(others(":04000005080000ed02\r\n:040000031000F000F9\r\n:00010001fe  \r\n\x1A"),
              (std::vector<std::string>{":00010001FE", ":040000031000F000F9", ":04000005080000ED02"}));
}

TEST(IntelHexFile, is_cut_at_multiples_of_its_record_length_when_that_is_a_power_of_two) {
    IntelHex file;
    file.style.data_bytes = 4;
    file.memory = Memory(3, base::Bytes{1, 2, 3, 4, 5, 6});
    EXPECT_EQ(write_intel_hex(file), ":0100030001FB\n:0400040002030405EA\n:0100080006F1\n:00000001FF\n");
    file.style.data_bytes = 5;
    EXPECT_EQ(write_intel_hex(file), ":050003000102030405E9\n:0100080006F1\n:00000001FF\n");
}

TEST(IntelHexFile, may_end_like_a_text_of_dos) {
    EXPECT_EQ(refusal(read(good + "\x1A")), "");
    EXPECT_EQ(refusal(read(good + "\x1A\x1A\r\n")), "");
    EXPECT_EQ(refusal(read(good + "\x1A\n:00000001FF")),
              "8:1-12 record-end: something follows the end record");
    EXPECT_EQ(refusal(read("\x1A" + good)), "1:1-17 record-line: a record begins with ':'");
}

// Each gap costs memory of its own.
TEST(IntelHexFile, is_refused_when_it_has_more_gaps_than_any_firmware) {
    Pieces pieces;
    const Line line{":", 7};
    for (std::uint64_t i = 0; i < 65536; ++i) {
        pieces.add(2 * i, base::Bytes{1}, line);
    }
    EXPECT_EQ(refusal(Pieces(pieces).join()), "");
    pieces.add(3, base::Bytes{1}, line);  // fills a gap
    EXPECT_EQ(refusal(Pieces(pieces).join()), "");
    pieces.add(1000000, base::Bytes{1}, line);
    pieces.add(2000000, base::Bytes{1}, line);
    EXPECT_EQ(
        refusal(pieces.join()),
        "7:1-2 record-address: this begins block 65537 of the data: a firmware does not have so many gaps");
}

TEST(IntelHexFile, is_refused_at_the_place_of_its_fault) {
    const auto with = [](const std::string& old, const std::string& text) {
        return refusal(read(replaced(good, old, text)));
    };
    EXPECT_EQ(with("0E0F89", "0E0F88"), "2:42-44 record-checksum: the checksum is 88, the bytes give 89");
    EXPECT_EQ(with(":04000000", ":05000000"),
              "4:1-20 record-line: the record says it has 5 data bytes, and has 4");
    EXPECT_EQ(with("13B6", "13B"),
              "4:18-19 record-line: the record ends within a byte: the number of digits is odd");
    EXPECT_EQ(with("13B6", "1GB6"), "4:17-18 record-line: 'G' is no hexadecimal digit");
    EXPECT_EQ(with(":0400000010111213B6", ":000000"),
              "4:1-8 record-line: a record has at least 5 bytes, this has 3");
    EXPECT_EQ(with(":0400000010111213B6", "; comment"), "4:1-10 record-line: a record begins with ':'");
    EXPECT_EQ(with(":020000040801F1", ":020000060801EF"),
              "3:8-10 record-line: there are no records of type 06");
    EXPECT_EQ(with(":020000040801F1", ":0100000408F3"),
              "3:2-4 record-line: a record of type 04 has 2 data bytes, this has 1");
    EXPECT_EQ(with(":04000005080000ED02", ":04000005080000ED02\n:04000005080000ED02"),
              "6:1-20 record-line: this is a second start address");
    EXPECT_EQ(
        with(":10FFF000000102030405060708090A0B0C0D0E0F89", ":10FFF100000102030405060708090A0B0C0D0E0F88"),
        "2:4-8 record-address: the record runs over the end of its 64 KiB");
    EXPECT_EQ(with(":020000040801F1\n:0400000010111213B6", ":04FFF20010111213C5"),
              "3:1-20 record-address: address 0x0800FFF2 is given again; line 2 has it already");
    EXPECT_EQ(with(":00000001FF\n", ""),
              "5:1-1 record-end: the file ends without an end record (:00000001FF): it is not whole");
    EXPECT_EQ(with(":00000001FF\n", ":00000001FF\n:00000001FF\n"),
              "7:1-12 record-end: something follows the end record");
    EXPECT_EQ(refusal(read("")),
              "0:1-1 record-end: the file ends without an end record (:00000001FF): it is not whole");
}

TEST(IntelHexFile, is_never_taken_when_it_was_cut_or_a_digit_changed) {
    for (std::size_t size = 0; size + 1 < good.size(); ++size) {
        EXPECT_NE(refusal(read(good.substr(0, size))), "") << size;
    }
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        const std::string damaged = test::flipped(good, bit);
        const Outcome<IntelHex> file = read(damaged);
        EXPECT_TRUE(!file || write_intel_hex(*file) == good) << damaged;
    }
}

}  // namespace
}  // namespace cgw::firmware_file
