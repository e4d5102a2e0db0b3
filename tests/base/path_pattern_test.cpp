#include "base/path_pattern.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace cgw::base {
namespace {

namespace fs = std::filesystem;

class PathPatterns : public ::testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() / fs::path("cgw-patterns-XXXXXX");
        std::string name = root_.string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root_ = name;
        for (const char* path : {"b.toml", "a.toml", "a.txt", ".hidden.toml", "one/c.toml", "one/two/d.toml",
                                 "one/two/e.toml", ".git/f.toml", "x[1].toml"}) {
            fs::create_directories((root_ / path).parent_path());
            std::ofstream(root_ / path) << "x";
        }
        fs::create_directory_symlink(root_, root_ / "one" / "loop");
        fs::create_directory(root_ / "directory.toml");
    }
    void TearDown() override { fs::remove_all(root_); }

    // Seen from the root of the test, separated by blanks.
    std::string found(const std::string& pattern) const {
        const auto files = files_of_pattern((root_ / pattern).string());
        if (!files) {
            return files.error().message;
        }
        std::string text;
        for (const std::string& file : *files) {
            text += (text.empty() ? "" : " ") + file.substr(root_.string().size() + 1);
        }
        return text;
    }

    fs::path root_;
};

}  // namespace

TEST_F(PathPatterns, are_sorted_and_leave_out_hidden_files_and_directories) {
    EXPECT_EQ(found("*.toml"), "a.toml b.toml x[1].toml");
    EXPECT_EQ(found(".*.toml"), ".hidden.toml");
    EXPECT_EQ(found("?.toml"), "a.toml b.toml");
    EXPECT_EQ(found("[b-z].toml"), "b.toml");
    EXPECT_EQ(found("*/*.toml"), "one/c.toml");
    EXPECT_EQ(found("*.yaml"), "");
    EXPECT_EQ(found("missing/*.toml"), "");
    EXPECT_EQ(found("a.toml/*"), "");
}

TEST_F(PathPatterns, go_into_directories_but_not_through_links) {
    EXPECT_EQ(found("**/*.toml"), "a.toml b.toml one/c.toml one/two/d.toml one/two/e.toml x[1].toml");
    EXPECT_EQ(found("**/**/d.toml"), "one/two/d.toml");
    EXPECT_EQ(found("one/**/*.toml"), "one/c.toml one/two/d.toml one/two/e.toml");
    EXPECT_EQ(found("**/two/**/*.toml"), "one/two/d.toml one/two/e.toml");
    EXPECT_EQ(found("one/loop/?.toml"), "one/loop/a.toml one/loop/b.toml");
    EXPECT_EQ(found("**"), "");
}

TEST_F(PathPatterns, a_file_of_that_name_is_no_pattern) {
    EXPECT_FALSE(is_path_pattern((root_ / "x[1].toml").string()));
    EXPECT_TRUE(is_path_pattern((root_ / "x[2].toml").string()));
    EXPECT_FALSE(is_path_pattern("missing.toml"));
    EXPECT_TRUE(is_path_pattern("*.toml"));
    EXPECT_FALSE(is_path_pattern("-"));
}

TEST_F(PathPatterns, an_unreadable_directory_is_told) {
    fs::permissions(root_ / "one" / "two", fs::perms::none);
    if (std::ifstream(root_ / "one" / "two" / "d.toml")) {
        GTEST_SKIP() << "this user may read everything";
    }
    EXPECT_NE(found("**/*.toml").find("cannot read the directory"), std::string::npos);
    fs::permissions(root_ / "one" / "two", fs::perms::owner_all);
}

}  // namespace cgw::base
