#include "media/log_stream.hpp"

#include "sample_log.hpp"
#include "support/golden.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::media {
namespace {

// Written one by one, with the file looked at in between.
std::string streamed(LogFormat format) {
    const cgw::test::ScratchDirectory directory;
    const std::string path = directory.write("run", "what was there before");
    auto stream = LogStream::open(path, format);
    EXPECT_TRUE(stream.has_value());
    for (const LoggedFrame& logged : test::sample_log()) {
        stream->record(logged);
        EXPECT_TRUE(stream->flush().has_value());
        EXPECT_FALSE(stream->waiting());
        EXPECT_TRUE(read_log(cgw::test::read_text(path), path).has_value());
    }
    EXPECT_EQ(stream->frames(), test::sample_log().size());
    EXPECT_EQ(stream->dropped(), 0U);
    return cgw::test::read_text(path);
}

TEST(LogStream, makes_the_same_file_as_writing_it_at_once) {
    for (const LogFormat format : {LogFormat::candump, LogFormat::pcap}) {
        const auto whole = write_log(format, test::sample_log());
        ASSERT_TRUE(whole.has_value());
        EXPECT_EQ(streamed(format), std::string(whole->begin(), whole->end()));
    }
}

TEST(LogStream, makes_a_valid_pcap_file_even_without_frames) {
    const cgw::test::ScratchDirectory directory;
    const std::string path = directory.write("run.pcap", "");
    auto stream = LogStream::open(path, LogFormat::pcap);
    ASSERT_TRUE(stream->flush().has_value());
    const auto log = read_log(cgw::test::read_text(path), path);
    ASSERT_TRUE(log.has_value()) << log.error().message;
    EXPECT_TRUE(log->frames.empty());
}

TEST(LogStream, says_why_a_file_cannot_be_made) {
    const auto stream = LogStream::open("/nowhere/run.log", LogFormat::candump);
    ASSERT_FALSE(stream.has_value());
    EXPECT_EQ(stream.error().message, "cannot write /nowhere/run.log: No such file or directory");
}

TEST(LogStream, keeps_what_a_full_disk_does_not_take_within_a_limit) {
    auto stream = LogStream::open("/dev/full", LogFormat::candump);
    ASSERT_TRUE(stream.has_value());
    const LoggedFrame logged = test::sample_log().front();
    stream->record(logged);
    const auto flushed = stream->flush();
    ASSERT_FALSE(flushed.has_value());
    EXPECT_EQ(flushed.error().message, "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(stream->waiting());
    while (stream->dropped() == 0) {
        stream->record(logged);
    }
    EXPECT_GT(stream->frames(), 50'000U);
    EXPECT_LT(stream->frames(), 300'000U);
}

}  // namespace
}  // namespace cgw::media
