#include "base/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>

#include "support/golden.hpp"

namespace base = cgw::base;
namespace fs = std::filesystem;

namespace {

class Files : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "cgw-files-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        directory_ = pattern;
    }
    void TearDown() override { fs::remove_all(directory_); }

    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
    }
    static base::Bytes bytes(const std::string& text) { return base::to_bytes(text); }

    fs::path directory_;
};

}  // namespace

TEST_F(Files, are_read_whole_and_the_limit_is_named) {
    std::ofstream(directory_ / "f") << "12345";
    EXPECT_EQ(*base::read_file((directory_ / "f").string(), 5), "12345");
    const auto too_large = base::read_file((directory_ / "f").string(), 4);
    ASSERT_FALSE(too_large);
    EXPECT_TRUE(too_large.error().too_large);
    EXPECT_NE(too_large.error().message.find("larger than 4 bytes"), std::string::npos);
}

TEST_F(Files, that_cannot_be_read_say_why) {
    const auto missing = base::read_file((directory_ / "none").string(), 10);
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);
    EXPECT_FALSE(missing.error().too_large);
    EXPECT_FALSE(base::read_file(directory_.string(), 10));
}

TEST_F(Files, reading_an_endless_stream_ends_at_the_limit) {
    EXPECT_FALSE(base::read_file("/dev/zero", 100000));
}

TEST_F(Files, appear_together_and_only_when_committed) {
    {
        base::FileSet set;
        ASSERT_TRUE(set.stage(directory_ / "a", bytes("A")));
        ASSERT_TRUE(set.stage(directory_ / "b", bytes("B")));
        EXPECT_FALSE(fs::exists(directory_ / "a"));
        ASSERT_TRUE(set.commit());
    }
    EXPECT_EQ(cgw::test::read_text(directory_ / "a"), "A");
    EXPECT_EQ(cgw::test::read_text(directory_ / "b"), "B");
    EXPECT_EQ(entries(), 2U);
}

TEST_F(Files, staged_and_abandoned_leave_nothing) {
    {
        base::FileSet set;
        ASSERT_TRUE(set.stage(directory_ / "a", bytes("A")));
    }
    EXPECT_EQ(entries(), 0U);
}

TEST_F(Files, with_the_same_content_stay_untouched) {
    ASSERT_TRUE(base::write_file(directory_ / "a", bytes("same")));
    const auto before = fs::last_write_time(directory_ / "a") - std::chrono::hours(1);
    fs::last_write_time(directory_ / "a", before);
    ASSERT_TRUE(base::write_file(directory_ / "a", bytes("same")));
    EXPECT_EQ(fs::last_write_time(directory_ / "a"), before);
    ASSERT_TRUE(base::write_file(directory_ / "a", bytes("other")));
    EXPECT_NE(fs::last_write_time(directory_ / "a"), before);
}

TEST_F(Files, are_written_through_a_link) {
    ASSERT_TRUE(base::write_file(directory_ / "target", bytes("old")));
    fs::create_symlink(directory_ / "target", directory_ / "link");
    ASSERT_TRUE(base::write_file(directory_ / "link", bytes("new")));
    EXPECT_TRUE(fs::is_symlink(directory_ / "link"));
    EXPECT_EQ(cgw::test::read_text(directory_ / "target"), "new");
}

TEST_F(Files, that_cannot_be_written_leave_the_old_content) {
    EXPECT_FALSE(base::write_file(directory_ / "missing" / "a", bytes("x")));
    EXPECT_FALSE(base::write_file(directory_, bytes("x")));
    const auto full = base::write_file("/dev/full", bytes("x"));
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.find("No space left"), std::string::npos);
}

TEST_F(Files, get_the_permissions_of_the_umask) {
    const mode_t before = ::umask(022);
    ASSERT_TRUE(base::write_file(directory_ / "a", bytes("x")));
    ::umask(before);
    EXPECT_EQ(fs::status(directory_ / "a").permissions(), static_cast<fs::perms>(0644));
}
