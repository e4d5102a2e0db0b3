#include "runtime/error_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/golden.hpp"
#include "support/scratch_directory.hpp"

namespace cgw::runtime {
namespace {

constexpr const char* id = "0123456789abcdef";

Sentinels some() {
    Sentinels sentinels{};
    sentinels[0] = 1;    // 3170
    sentinels[2] = 255;  // 3172
    sentinels[24] = 17;  // 3194
    return sentinels;
}

TEST(ErrorMemory, is_text_with_a_line_per_sentinel_that_is_not_0) {
    EXPECT_EQ(error_memory_text(some(), id),
              "canopen-gateway error memory 1\n"
              "configuration 0123456789abcdef\n"
              "3170 1\n3172 255\n3194 17\nend\n");
    EXPECT_EQ(error_memory_text({}, id),
              "canopen-gateway error memory 1\nconfiguration 0123456789abcdef\nend\n");
}

TEST(ErrorMemory, reads_what_it_writes) {
    for (const Sentinels& sentinels : {Sentinels{}, some()}) {
        const auto read = parse_error_memory(error_memory_text(sentinels, id), "state");
        ASSERT_TRUE(read.has_value()) << read.error().message;
        EXPECT_EQ(*read, sentinels);
    }
}

TEST(ErrorMemory, refuses_damaged_and_foreign_files_with_the_line) {
    const std::string head = "canopen-gateway error memory 1\nconfiguration 00\n";
    const std::string sentinel = "expected a number 3170..3194, ascending, and a count 1..255";
    const std::pair<std::string, std::string> cases[] = {
        {"", "state:1: this is no error memory of canopen-gateway"},
        {"format = 1\n", "state:1: this is no error memory of canopen-gateway"},
        {"canopen-gateway error memory \n", "state:1: this is no error memory of canopen-gateway"},
        {"canopen-gateway error memory 2\nend\n", "state:1: error memory of format 2; this program knows 1"},
        {"canopen-gateway error memory 1", "state:1: this is no error memory of canopen-gateway"},
        {"canopen-gateway error memory 1\n", "state:2: the file is cut off"},
        {"canopen-gateway error memory 1\nend\n", "state:2: expected 'configuration' and its id"},
        {"canopen-gateway error memory 1\nconfiguration xyz\n",
         "state:2: expected 'configuration' and its id"},
        {head, "state:3: the file is cut off"},
        {head + "3170 1\n", "state:4: the file is cut off"},
        {head + "3170 1\nend", "state:4: the file is cut off"},
        {head + "end\n\n", "state:3: something follows the end"},
        {head + "3170\nend\n", "state:3: " + sentinel},
        {head + "3170 0\nend\n", "state:3: " + sentinel},
        {head + "3170 256\nend\n", "state:3: " + sentinel},
        {head + "3170 -1\nend\n", "state:3: " + sentinel},
        {head + "3169 1\nend\n", "state:3: " + sentinel},
        {head + "3195 1\nend\n", "state:3: " + sentinel},
        {head + "3172 1\n3171 1\nend\n", "state:4: " + sentinel},
        {head + "3172 1\n3172 1\nend\n", "state:4: " + sentinel},
        {head + "\nend\n", "state:3: " + sentinel},
        {head + std::string(1, '\0') + "\nend\n", "state:3: " + sentinel},
    };
    for (const auto& [text, message] : cases) {
        const auto read = parse_error_memory(text, "state");
        ASSERT_FALSE(read.has_value()) << text;
        EXPECT_EQ(read.error().message, message) << text;
    }
}

class ErrorMemoryFile : public testing::Test {
  protected:
    std::string path(const std::string& name) {
        const std::string made = directory_.write(name, "");
        std::filesystem::remove(made);
        return made;
    }
    static ErrorMemory opened(const std::string& path) {
        auto memory = ErrorMemory::open(path, id);
        EXPECT_TRUE(memory.has_value()) << memory.error().message;
        return std::move(*memory);
    }
    test::ScratchDirectory directory_;
};

TEST_F(ErrorMemoryFile, begins_afresh_without_a_file_and_goes_on_with_one) {
    const std::string file = path("state");
    ErrorMemory memory = opened(file);
    EXPECT_EQ(memory.sentinels(), Sentinels{});
    EXPECT_TRUE(memory.keep(some()).has_value());
    EXPECT_EQ(opened(file).sentinels(), some());
}

TEST_F(ErrorMemoryFile, writes_at_first_and_then_only_what_has_changed) {
    const std::string file = path("state");
    ErrorMemory memory = opened(file);
    ASSERT_TRUE(memory.keep({}).has_value());
    EXPECT_TRUE(std::filesystem::exists(file));
    std::filesystem::remove(file);
    ASSERT_TRUE(memory.keep({}).has_value());
    EXPECT_FALSE(std::filesystem::exists(file));
    ASSERT_TRUE(memory.keep(some()).has_value());
    EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(ErrorMemoryFile, refuses_files_that_are_none_of_its_own) {
    const std::string foreign = directory_.write("foreign", "hello\n");
    EXPECT_EQ(ErrorMemory::open(foreign, id).error().message,
              foreign + ":1: this is no error memory of canopen-gateway");
    EXPECT_EQ(test::read_text(foreign), "hello\n");
    const std::string large = directory_.write("large", std::string(ErrorMemory::largest_file + 1, 'x'));
    EXPECT_EQ(ErrorMemory::open(large, id).error().message,
              "cannot read " + large + ": it is larger than 4096 bytes");
    for (const char* special : {"/dev/full", "/"}) {
        EXPECT_EQ(ErrorMemory::open(special, id).error().message,
                  std::string(special) + ": an error memory is kept in a regular file");
    }
    const std::string nowhere = path("missing") + "/state";
    EXPECT_EQ(ErrorMemory::open(nowhere, id).error().message,
              "cannot write " + nowhere + ": there is no such directory");
}

TEST_F(ErrorMemoryFile, fails_on_a_full_disk_and_works_again_after_it) {
    const std::string file = path("state");
    ErrorMemory memory = opened(file);
    ASSERT_EQ(::symlink("/dev/full", file.c_str()), 0);
    const auto kept = memory.keep(some());
    ASSERT_FALSE(kept.has_value());
    EXPECT_EQ(kept.error().message, "cannot write " + file + ": No space left on device");
    std::filesystem::remove(file);
    EXPECT_TRUE(memory.keep(some()).has_value());
    EXPECT_EQ(opened(file).sentinels(), some());
}

}  // namespace
}  // namespace cgw::runtime
