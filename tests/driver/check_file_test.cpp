#include "driver/check_file.hpp"

#include <gtest/gtest.h>

namespace cgw::driver {

TEST(CheckFile, gives_settings_and_configuration_of_a_valid_file) {
    const CheckedFile file = check_file(CGW_SAMPLES "/genset.toml");
    ASSERT_TRUE(file.valid());
    EXPECT_TRUE(file.findings.all().empty());
    EXPECT_EQ(file.dependencies, std::vector<std::string>{CGW_SAMPLES "/genset.toml"});
    EXPECT_TRUE(file.configuration.tpdo(4).active);
    EXPECT_NE(file.configuration.node_id, 0);
}

TEST(CheckFile, reports_a_file_that_is_not_there) {
    const CheckedFile file = check_file("/nonexistent/plant.toml");
    EXPECT_TRUE(file.unreadable);
    EXPECT_FALSE(file.valid());
    ASSERT_EQ(file.findings.all().size(), 1U);
    EXPECT_EQ(file.findings.all()[0].rule, &diagnostic::rules::file_unreadable);
}

TEST(CheckFile, reports_a_stream_that_is_too_large_as_a_finding_about_the_file) {
    const CheckedFile file = check_file("/dev/zero");
    EXPECT_FALSE(file.unreadable);
    ASSERT_EQ(file.findings.all().size(), 1U);
    EXPECT_EQ(file.findings.all()[0].rule, &diagnostic::rules::file_too_large);
}

}  // namespace cgw::driver
