#include "parameter/canonical_model.hpp"

#include <gtest/gtest.h>

namespace cgw::parameter {
namespace {

const std::string text =
    "cgw-configuration 1\n"
    "title \"Genset \\\"2\\\"\"\n"
    "identity 12 407 13\n"
    "main-cycle-us 15625\n"
    "row governor 812 \"FunctDroop\" parameter switch\n"
    "row governor 2990 \"TorqueActual\" measurement 16 signed \"%\" -32768..32767 @980..?\n"
    "governor 400 0.5\n"
    "governor 401 1\n"
    "gateway 16404 642\n";

std::string replaced(const std::string& old, const std::string& with) {
    std::string changed = text;
    return changed.replace(changed.find(old), old.size(), with);
}

TEST(CanonicalModel, is_what_the_canonical_text_says) {
    const auto model = read_canonical_text(text);
    ASSERT_TRUE(model);
    EXPECT_EQ(model->title, "Genset \"2\"");
    EXPECT_EQ(model->identity.serial_date, 407U);
    EXPECT_EQ(model->main_cycle_us, 15'625U);
    ASSERT_EQ(model->rows.size(), 2U);
    EXPECT_EQ(model->rows[0].role, Role::switch_assignment);
    EXPECT_EQ(model->rows[1].scaling->external_minimum_parameter, 980);
    ASSERT_EQ(model->values.size(), 3U);
    EXPECT_EQ(model->values[2].device, Device::gateway);
    EXPECT_EQ(model->values[2].value, 642);
}

// Such a text would have another SHA-256 when cgw wrote it again.
TEST(CanonicalModel, is_refused_when_it_is_not_as_cgw_writes_it) {
    for (const auto& [old, with] : std::vector<std::pair<std::string, std::string>>{
             {"governor 401 1\n", "governor 401 1\ngovernor 401 2\n"},
             {"governor 401 1\n", "governor 401 1\ngovernor 401 1\n"},
             {"governor 401 1\n", "governor 401 0\n"},
             {"governor 401 1\n", "governor 401 1.0\n"},
             {"governor 401 1\n", "governor 0401 1\n"},
             {"governor 400 0.5\ngovernor 401 1\n", "governor 401 1\ngovernor 400 0.5\n"},
             {"identity 12 407 13\n", ""},
             {"identity 12 407 13\n", "identity 12 407 13\nidentity 12 407 13\n"},
             {"\"FunctDroop\"", "\"Funct\\u0044roop\""},
             {"@980", "@0980"}}) {
        EXPECT_FALSE(read_canonical_text(replaced(old, with))) << with;
    }
    EXPECT_TRUE(read_canonical_text(replaced("governor 400 0.5\n", "")));
    EXPECT_FALSE(read_canonical_text(text + "\n"));
    EXPECT_FALSE(read_canonical_text(text.substr(0, text.size() - 1)));
    EXPECT_FALSE(read_canonical_text(""));
}

}  // namespace
}  // namespace cgw::parameter
