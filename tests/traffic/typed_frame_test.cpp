// Frames as people type them.
#include "traffic/typed_frame.hpp"

#include <gtest/gtest.h>

#include "media/candump.hpp"

namespace cgw::traffic {
namespace {

std::string read(const std::vector<std::string>& words) {
    diagnostic::Findings findings;
    const frame::Frame frame = read_typed_frame(words, findings);
    if (!findings.all().empty()) {
        EXPECT_EQ(findings.all().size(), 1U);
        return findings.all().front().message;
    }
    return media::candump_line({0, "x", frame}).substr(22);
}

}  // namespace

TEST(TypedFrame, is_read_in_every_spelling) {
    EXPECT_EQ(read({"0x181", "A0", "0F"}), "181#A00F");
    EXPECT_EQ(read({"181h", "a00f"}), "181#A00F");
    EXPECT_EQ(read({"181#A00F"}), "181#A00F");
    EXPECT_EQ(read({"0x181", "0xA0", "0x0F"}), "181#A00F");
    EXPECT_EQ(read({"0x0"}), "000#");
    EXPECT_EQ(read({"0x70C", "R"}), "70C#R");
    EXPECT_EQ(read({"70C#R"}), "70C#R");
    EXPECT_EQ(read({"0x181", "0102030405060708"}), "181#0102030405060708");
}

TEST(TypedFrame, says_what_is_wrong) {
    EXPECT_EQ(read({"0x800"}), "an identifier is at most 7FFh");
    EXPECT_EQ(read({"0xG"}), "this is no identifier");
    EXPECT_EQ(read({"0x"}), "this is no identifier");
    EXPECT_EQ(read({"0x-1"}), "this is no identifier");
    EXPECT_EQ(read({"#11"}), "this is no identifier");
    EXPECT_EQ(read({"0x181", "A"}), "these are no bytes");
    EXPECT_EQ(read({"0x181", "A0", "xx"}), "these are no bytes");
    EXPECT_EQ(read({"0x181", "010203040506070809"}), "a frame has at most 8 bytes");
    EXPECT_EQ(read({"0x70C", "01", "R"}), "a remote frame has no data");
}

TEST(TypedFrame, is_told_from_the_name_of_a_file) {
    for (const char* const frame : {"0x181", "181h", "181#", "181#00"}) {
        EXPECT_TRUE(begins_frame(frame)) << frame;
    }
    for (const char* const file : {"", "run.log", "-", "181", "./0x181", "h", "bench/tests#1.log", "cash"}) {
        EXPECT_FALSE(begins_frame(file)) << file;
    }
}

}  // namespace cgw::traffic
