#include "runtime/keeper.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/golden.hpp"
#include "support/recording_port.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::runtime {
namespace {

class KeeperFiles : public testing::Test {
  protected:
    Keeper keeper(const std::string& log, const std::string& state) {
        std::optional<media::LogStream> stream;
        if (!log.empty()) {
            stream = std::move(*media::LogStream::open(log, media::LogFormat::candump));
        }
        std::optional<ErrorMemory> memory;
        if (!state.empty()) {
            memory = std::move(*ErrorMemory::open(state, "00"));
        }
        return {std::move(stream), std::move(memory),
                [this](std::string_view line) { lines.emplace_back(line); }};
    }
    std::string path(const char* name) {
        const std::string made = directory_.write(name, "");
        std::filesystem::remove(made);
        return made;
    }
    test::ScratchDirectory directory_;
    std::vector<std::string> lines;
};

TEST_F(KeeperFiles, keeps_the_frames_of_both_sides_by_name) {
    const std::string log = path("run.log");
    Keeper keeper = this->keeper(log, "");
    keeper.record(Side::can1, test::make_frame(0x123, {1}), 1'000'001);
    keeper.record(Side::can2, test::make_frame(0x124, {}), 2'000'000);
    keeper.write({});
    EXPECT_EQ(test::read_text(log), "(0000000001.000001) can1 123#01\n(0000000002.000000) can2 124#\n");
    EXPECT_TRUE(keeper.complete());
    EXPECT_TRUE(lines.empty());
}

TEST_F(KeeperFiles, has_nothing_to_do_without_files) {
    Keeper keeper = this->keeper("", "");
    EXPECT_FALSE(keeper.has_work());
    keeper.record(Side::can1, test::make_frame(1, {}), 0);
    keeper.write({});
    EXPECT_TRUE(keeper.complete());
}

TEST_F(KeeperFiles, says_once_that_a_file_cannot_be_written_and_once_that_it_can_again) {
    const std::string state = path("state");
    Keeper keeper = this->keeper("", state);
    ASSERT_EQ(::symlink("/dev/full", state.c_str()), 0);
    Sentinels sentinels{};
    sentinels[2] = 1;
    keeper.write(sentinels);
    keeper.write(sentinels);
    EXPECT_FALSE(keeper.complete());
    std::filesystem::remove(state);
    keeper.write(sentinels);
    EXPECT_TRUE(keeper.complete());
    EXPECT_EQ(lines,
              (std::vector<std::string>{
                  "cannot write " + state + ": No space left on device; the gateway goes on, and tries again",
                  state + " can be written again"}));
}

TEST_F(KeeperFiles, is_incomplete_while_frames_of_the_log_are_not_in_their_file) {
    Keeper keeper = this->keeper("/dev/full", "");
    keeper.record(Side::can1, test::make_frame(1, {}), 0);
    keeper.write({});
    EXPECT_FALSE(keeper.complete());
    EXPECT_EQ(lines.size(), 1U);
}

}  // namespace
}  // namespace cgw::runtime
