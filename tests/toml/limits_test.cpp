// What is refused before anything is read: size, depth, bytes that are no text, numbers that do not fit.
#include "toml/support.hpp"

namespace cgw {
namespace {

using test::findings_of;

std::string repeated(std::string_view part, std::size_t count) {
    std::string text;
    text.reserve(part.size() * count);
    for (std::size_t i = 0; i < count; ++i) {
        text += part;
    }
    return text;
}

TEST(TomlLimits, numbers_beyond_64_bits_are_findings_at_their_place) {
    EXPECT_EQ(findings_of("a = 9223372036854775808\nb = 1\nc = [1, -9223372036854775809]\n"),
              "E0005 1:5 9223372036854775808 does not fit 64 bits with sign\n"
              "E0005 3:9 -9223372036854775809 does not fit 64 bits with sign");
    EXPECT_EQ(findings_of("a = 0x8000000000000000\n"),
              "E0005 1:5 0x8000000000000000 does not fit 64 bits with sign");
    EXPECT_EQ(findings_of("a = 0o1000000000000000000000\n"),
              "E0005 1:5 0o1000000000000000000000 does not fit 64 bits with sign");
    EXPECT_EQ(findings_of("a = 0b" + repeated("1", 64) + "\n"),
              "E0005 1:5 0b11111111111111111111111111111111111111... does not fit 64 bits with sign");
}

TEST(TomlLimits, decimal_numbers_beyond_a_double_are_findings) {
    EXPECT_EQ(findings_of("a = 1e400\n"), "E0005 1:5 1e400 does not fit a double-precision number");
    EXPECT_EQ(findings_of("a = -1.5e+309\n"), "E0005 1:5 -1.5e+309 does not fit a double-precision number");
    EXPECT_EQ(findings_of("a = 1.7e308\n"), "fine");
}

TEST(TomlLimits, nesting_is_capped_at_64) {
    EXPECT_EQ(findings_of("a = " + repeated("[", 63) + repeated("]", 63) + "\n"), "fine");
    EXPECT_EQ(findings_of("a = " + repeated("[", 65) + repeated("]", 65) + "\n"),
              "E0006 1:69 tables and arrays are nested more than 64 deep");
    EXPECT_EQ(findings_of("a = " + repeated("{a=", 65) + "1" + repeated("}", 65) + "\n").substr(0, 5),
              "E0006");
    EXPECT_EQ(findings_of("[" + repeated("a.", 63) + "a]\n"), "fine");
    EXPECT_EQ(findings_of("[" + repeated("a.", 64) + "a]\n"), "E0006 1:130 a key has more than 64 parts");
    EXPECT_EQ(findings_of("[" + repeated("a.", 62) + "a]\nb.c = [1]\n"),
              "E0006 2:3 tables and arrays are nested more than 64 deep");
}

TEST(TomlLimits, hostile_nesting_is_refused_and_does_not_crash) {
    for (const char* part : {"[", "{a=", "[{a=", "a.", "[[a."}) {
        const std::string text = "a = " + repeated(part, 20'000);
        EXPECT_NE(findings_of(text), "fine") << part;
        EXPECT_NE(findings_of(repeated(part, 20'000)), "fine") << part;
    }
}

TEST(TomlLimits, a_file_has_at_most_4_mib) {
    // The mistake in the first line shows that the text is read.
    const std::string text = "=\n" + std::string(toml::maximum_file_size - 2, ' ');
    EXPECT_EQ(findings_of(text), "E0004 1:1 expected a key, found '='");
    EXPECT_EQ(findings_of(text + " "), "E0002 0:0 the file has 4194305 bytes; the limit is 4194304");
}

TEST(TomlLimits, bytes_that_are_not_utf8_are_found_where_they_are) {
    EXPECT_EQ(findings_of("a = 1\nb = \"\xE4\"\n"), "E0003 2:6 byte 0xE4 is not UTF-8");
    EXPECT_EQ(findings_of("# \xC3"), "E0003 1:3 byte 0xC3 is not UTF-8");
    EXPECT_EQ(findings_of("# \xED\xA0\x80\n"), "E0003 1:3 byte 0xED is not UTF-8");
    EXPECT_EQ(findings_of("# \xC0\x80\n"), "E0003 1:3 byte 0xC0 is not UTF-8");
    EXPECT_EQ(findings_of(std::string_view("\xFF\xFE"
                                           "a\0",
                                           4)),
              "E0003 1:1 byte 0xFF is not UTF-8");
}

TEST(TomlLimits, control_characters_are_found_where_they_are) {
    EXPECT_EQ(findings_of(std::string_view("a = 1\0\n", 7)), "E0003 1:6 control character 0x00 in the text");
    EXPECT_EQ(findings_of("# \x1B[31m\n"), "E0003 1:3 control character 0x1B in the text");
    EXPECT_EQ(findings_of("a = \"\x7F\"\n"), "E0003 1:6 control character 0x7F in the text");
    EXPECT_EQ(findings_of("a = 1\rb = 2\n"), "E0003 1:6 a carriage return (0x0D) stands without a line feed");
    EXPECT_EQ(findings_of("a = 1\r"), "E0003 1:6 a carriage return (0x0D) stands without a line feed");
}

TEST(TomlLimits, a_file_in_utf16_gets_advice) {
    diagnostic::Findings findings;
    EXPECT_FALSE(toml::parse(std::string_view("\xFF\xFE"
                                              "a\0",
                                              4),
                             "f.toml", findings));
    ASSERT_EQ(findings.all().size(), 1U);
    EXPECT_EQ(findings.all()[0].help, "the file looks like UTF-16; save it as UTF-8");
}

TEST(TomlLimits, long_lines_full_of_values_are_refused_before_they_take_long) {
    constexpr const char* finding = "the file has too many values on too long lines";
    EXPECT_NE(findings_of("a = [" + repeated("1234,", 12'000) + "]\n").find(finding), std::string::npos);
    EXPECT_NE(findings_of("a = [" + repeated("1,", 60'000) + "]\n").find(finding), std::string::npos);
    EXPECT_NE(
        findings_of("a = [\n" + repeated("#\n", 100'000) + repeated("1,", 20'000) + "]\n").find(finding),
        std::string::npos);
    EXPECT_EQ(findings_of("a = [" + repeated("1234,", 1'000) + "]\n"), "fine");
}

TEST(TomlLimits, many_lines_are_fine) {
    std::string text = "[a]\n";
    for (int i = 0; i < 2'000; ++i) {
        text += fmt::format("k{} = {} # comment\n", i, i);
    }
    const toml::Node document = test::parsed(text);
    EXPECT_EQ(test::show(test::at(document, "a/k1999").range), "2001:9-2001:13");
}

}  // namespace
}  // namespace cgw
