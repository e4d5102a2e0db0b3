// Whatever bytes come, the readers neither crash nor make frames that no bus has, and what they read can be
// written and read again.
#include <random>

#include "media/log.hpp"
#include "media/slcan_line.hpp"
#include "sample_log.hpp"

namespace cgw::media {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
}

char random_byte(Random& random) {
    return static_cast<char>(below(random, 256));
}

void expect_possible(const frame::Frame& frame) {
    ASSERT_LE(frame.length, 8);
    ASSERT_LE(frame.id, frame.extended ? 0x1FFF'FFFFU : 0x7FFU);
}

void expect_sound(const base::Result<Log>& log, LogFormat format) {
    if (!log) {
        ASSERT_TRUE(log.error().message.starts_with("run:")) << log.error().message;
        return;
    }
    for (const LoggedFrame& logged : log->frames) {
        expect_possible(logged.frame);
    }
    const base::Result<base::Bytes> written = write_log(format, log->frames);
    ASSERT_TRUE(written.has_value());
    const base::Result<Log> again = read_log(std::string(written->begin(), written->end()), "run");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    ASSERT_EQ(again->frames, log->frames);
}

std::string sample(LogFormat format) {
    const base::Result<base::Bytes> bytes = write_log(format, test::sample_log());
    return {bytes->begin(), bytes->end()};
}

class RandomLogs : public testing::TestWithParam<LogFormat> {};

TEST_P(RandomLogs, are_read_soundly_when_bytes_are_changed) {
    const std::string whole = sample(GetParam());
    Random random(4711);
    int read = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string content = whole;
        for (std::size_t changes = 1 + below(random, 4); changes > 0; --changes) {
            content[below(random, content.size())] = random_byte(random);
        }
        const base::Result<Log> log = read_log(content, "run");
        read += log ? 1 : 0;
        expect_sound(log, GetParam());
        if (HasFatalFailure()) {
            FAIL() << "in round " << round;
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, 20'000);
}

TEST_P(RandomLogs, are_read_soundly_when_they_are_cut_off) {
    const std::string whole = sample(GetParam());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        expect_sound(read_log(whole.substr(0, size), "run"), GetParam());
    }
}

TEST_P(RandomLogs, are_read_soundly_when_they_are_noise_behind_a_good_beginning) {
    const std::string whole = sample(GetParam());
    Random random(4712);
    for (int round = 0; round < 2'000; ++round) {
        std::string content = whole.substr(0, 4 + below(random, 60));
        for (std::size_t count = below(random, 300); count > 0; --count) {
            content += below(random, 3) == 0 ? random_byte(random) : '\0';
        }
        expect_sound(read_log(content, "run"), GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, RandomLogs, testing::Values(LogFormat::candump, LogFormat::pcap));

TEST(RandomSlcan, is_read_soundly) {
    constexpr std::string_view likely = "tTrR0123456789ABCDEFabcdef\r\r\r\a\nzSOCV";
    Random random(4713);
    SlcanReader reader;
    int frames = 0;
    for (int i = 0; i < 2'000'000; ++i) {
        const char next = below(random, 50) == 0 ? random_byte(random) : likely[below(random, likely.size())];
        const std::optional<SlcanEvent> event = reader.take(next);
        if (!event || event->answer != SlcanAnswer::frame) {
            continue;
        }
        ++frames;
        expect_possible(event->frame);
        std::string line = slcan_line(event->frame);
        line.pop_back();
        ASSERT_EQ(parse_slcan_line(line), event->frame) << line;
    }
    EXPECT_GT(frames, 10);
}

}  // namespace
}  // namespace cgw::media
