#include "driver/check_file.hpp"

#include <gtest/gtest.h>

#include "diagnostic/rules/files.hpp"
#include "diagnostic/rules/keys.hpp"
#include "support/scratch_directory.hpp"

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

constexpr std::string_view catalogue_text =
    "device = \"governor\"\n[[row]]\nnumber = 2990\nname = \"TorqueActual\"\nkind = \"measurement\"\nwidth = "
    "16\nsigned = false\n";

TEST(CheckFile, checks_a_catalogue_as_one_when_it_may_be_one) {
    const test::ScratchDirectory directory;
    const std::string path = directory.write("more.toml", std::string(catalogue_text));
    const CheckedFile file = check_file_or_catalogue(path);
    EXPECT_TRUE(file.is_catalogue);
    EXPECT_FALSE(file.valid());  // there is nothing to build from
    EXPECT_TRUE(file.findings.all().empty());
    const std::string wrong = directory.write("wrong.toml", std::string(catalogue_text) + "colour = 3\n");
    const CheckedFile refused = check_file_or_catalogue(wrong);
    EXPECT_TRUE(refused.is_catalogue);
    ASSERT_EQ(refused.findings.all().size(), 1U);
    EXPECT_EQ(refused.findings.all()[0].rule, &diagnostic::rules::key_unknown);
    EXPECT_EQ(refused.findings.all()[0].where.range.start.line, 8U);
}

TEST(CheckFile, takes_a_parameter_file_for_no_catalogue) {
    EXPECT_TRUE(check_file_or_catalogue(CGW_SAMPLES "/genset.toml").valid());
    const test::ScratchDirectory directory;
    const std::string path = directory.write("a.toml", "format = 1\ndevice = \"governor\"\n");
    EXPECT_FALSE(check_file_or_catalogue(path).is_catalogue);
}

TEST(CheckFile, refuses_a_catalogue_as_a_parameter_file_in_one_finding) {
    const CheckedFile file = check_text("more.toml", std::string(catalogue_text));
    ASSERT_EQ(file.findings.all().size(), 1U);
    EXPECT_EQ(file.findings.all()[0].message, "this is a catalogue file, not a parameter file");
}

}  // namespace cgw::driver
