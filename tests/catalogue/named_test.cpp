// The cells `bits`, `values` and `used`, and the programs of a device.
#include "catalogue/read_catalogue.hpp"

namespace {

using cgw::parameter::Device;
using cgw::parameter::Program;
using cgw::parameter::Row;
using cgw::test::torque;

using ReadNamed = cgw::test::ReadCatalogue;

const std::string word = torque + "width = 16\nsigned = false\n";

TEST_F(ReadNamed, keeps_bits_values_and_use) {
    ASSERT_EQ(row(word + "bits = [{ bit = 0, name = \"Running\", text = \"the engine runs\" }]\n"
                         "values = [{ value = 7, text = \"seven\" }]\nused = \"2001h\""),
              "");
    const Row* added = find(2990);
    ASSERT_EQ(added->bits.size(), 1U);
    EXPECT_EQ(added->bits[0].name, "Running");
    EXPECT_EQ(added->bits[0].text, "the engine runs");
    ASSERT_EQ(added->values.size(), 1U);
    EXPECT_EQ(added->values[0].value, 7U);
    EXPECT_EQ(added->values[0].text, "seven");
    EXPECT_EQ(added->used, "2001h");
}

TEST_F(ReadNamed, bits_with_last_count_along) {
    ASSERT_EQ(row(word + "bits = [{ bit = 2, last = 4, name = \"Pump{1}\", text = \"pump {1} of {x}\" }]"),
              "");
    const Row* added = find(2990);
    ASSERT_EQ(added->bits.size(), 3U);
    EXPECT_EQ(added->bits[2].bit, 4);
    EXPECT_EQ(added->bits[2].name, "Pump3");
    EXPECT_EQ(added->bits[2].text, "pump 3 of {x}");
}

TEST_F(ReadNamed, refuses_bits_that_cannot_be) {
    EXPECT_NE(row(word + "bits = [3]").find("an element is a table"), std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 32, name = \"A\", text = \"a\" }]").find("0 to 31"),
              std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 1, text = \"a\" }]").find("`name`"), std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 1, name = \"A\" }]").find("`text`"), std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 1, name = \"A b\", text = \"a\" }]").find("no name for a bit"),
              std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 1, nam = \"A\", text = \"a\" }]").find("unknown key `nam`"),
              std::string::npos);
    EXPECT_NE(row(word +
                  "bits = [{ bit = 1, name = \"A\", text = \"a\" }, { bit = 1, name = \"B\", text = \"b\" }]")
                  .find("bits ascend"),
              std::string::npos);
    EXPECT_NE(row(word + "bits = [{ bit = 3, last = 2, name = \"A\", text = \"a\" }]").find("bits ascend"),
              std::string::npos);
}

TEST_F(ReadNamed, refuses_values_that_cannot_be) {
    EXPECT_NE(row(word + "values = [{ value = -1, text = \"a\" }]").find("`value` is an integer"),
              std::string::npos);
    EXPECT_NE(row(word + "values = [{ value = 1, text = \"\" }]").find("`text`"), std::string::npos);
    EXPECT_NE(row(word + "values = [\"a\"]").find("an element is a table"), std::string::npos);
    EXPECT_NE(
        row(word + "values = [{ value = 2, text = \"a\" }, { value = 1, text = \"b\" }]").find("ascend"),
        std::string::npos);
}

TEST_F(ReadNamed, other_bits_than_the_shipped_ones_contradict_them) {
    EXPECT_NE(file("device = \"gateway\"\n[[row]]\nnumber = 3099\n"
                   "bits = [{ bit = 1, name = \"Other\", text = \"other\" }]\n")
                  .find("ErrorMemoryPages"),
              std::string::npos)
        << cgw::test::findings_text(findings);
}

TEST_F(ReadNamed, rows_of_the_bootloader_are_a_world_of_their_own) {
    ASSERT_EQ(file("device = \"gateway\"\nprogram = \"bootloader\"\n[[row]]\nnumber = 401\n"
                   "name = \"CanMyNodeNumber\"\nkind = \"measurement\"\n"),
              "");
    const Row* own = catalogue.find(Device::gateway, Program::bootloader, std::uint16_t{401});
    ASSERT_NE(own, nullptr);
    EXPECT_FALSE(own->settable());
    EXPECT_TRUE(catalogue.find(Device::gateway, std::uint16_t{401})->settable());
    ASSERT_EQ(catalogue.added().size(), 1U);
    EXPECT_EQ(catalogue.added().front(), own);
}

TEST_F(ReadNamed, refuses_an_unknown_program) {
    EXPECT_NE(file("device = \"gateway\"\nprogram = \"boot\"\n").find("neither"), std::string::npos);
    EXPECT_NE(file("device = \"gateway\"\nprogram = 1\n").find("`program` is a string"), std::string::npos);
}

}  // namespace
