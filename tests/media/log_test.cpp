#include "media/log.hpp"

#include "sample_log.hpp"

namespace cgw::media {
namespace {

std::string written(LogFormat format) {
    const base::Result<base::Bytes> bytes = write_log(format, test::sample_log());
    EXPECT_TRUE(bytes.has_value());
    return {bytes->begin(), bytes->end()};
}

TEST(LogFile, knows_the_format_by_the_name) {
    EXPECT_EQ(log_format_of("run.log"), LogFormat::candump);
    EXPECT_EQ(log_format_of("a.b/run.pcap"), LogFormat::pcap);
    EXPECT_EQ(log_format_of("RUN.CAP"), LogFormat::pcap);
    EXPECT_EQ(log_format_of("run.pcapng"), std::nullopt);
    EXPECT_EQ(log_format_of("log"), std::nullopt);
    EXPECT_EQ(log_format_of(""), std::nullopt);
}

TEST(LogFile, reads_either_kind_by_its_content) {
    for (const LogFormat format : {LogFormat::candump, LogFormat::pcap}) {
        const base::Result<Log> log = read_log(written(format), "run");
        ASSERT_TRUE(log.has_value()) << log.error().message;
        EXPECT_EQ(log->frames, test::sample_log());
        EXPECT_EQ(log->passed_over, 0U);
    }
}

TEST(LogFile, takes_an_empty_file_as_an_empty_log) {
    const base::Result<Log> log = read_log("", "run.log");
    ASSERT_TRUE(log.has_value());
    EXPECT_TRUE(log->frames.empty());
}

TEST(LogFile, hands_on_why_a_file_cannot_be_read) {
    EXPECT_EQ(read_log("hello\n", "run.log").error().message,
              "run.log:1: this is no frame as candump -L writes it");
    EXPECT_EQ(read_log(written(LogFormat::pcap).substr(0, 30), "run.log").error().message,
              "run.log: record 1: the file is cut off");
}

TEST(LogFile, hands_on_why_a_log_cannot_be_written) {
    const std::vector<LoggedFrame> late = {{4'294'967'296'000'000, "can0", {}}};
    EXPECT_FALSE(write_log(LogFormat::pcap, late).has_value());
    EXPECT_TRUE(write_log(LogFormat::candump, late).has_value());
}

}  // namespace
}  // namespace cgw::media
