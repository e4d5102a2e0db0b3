#include "dictionary/ascii.hpp"

#include <gtest/gtest.h>

namespace cgw::dictionary {

TEST(Ascii, leaves_printable_ascii_alone) {
    std::string printable;
    for (char c = ' '; c <= '~'; ++c) {
        printable += c;
    }
    EXPECT_EQ(to_ascii(printable), printable);
    EXPECT_EQ(to_ascii(""), "");
}

TEST(Ascii, spells_umlauts_and_signs) {
    EXPECT_EQ(to_ascii("Größe 5 °C, Öl & Übermaß"), "Groesse 5 degC, Oel & Uebermass");
    EXPECT_EQ(to_ascii("Ångström – 3 m³ “µ”"), "Aangstroem - 3 m3 \"u\"");
    EXPECT_EQ(to_ascii("ΔT 5 kΩ"), "DeltaT 5 kOhm");
    EXPECT_EQ(to_ascii("‰ m²"), "permille m2");
    EXPECT_EQ(to_ascii("min⁻¹, N⋅m, 20 ℃, 68 ℉, 293 \xE2\x84\xAA"), "min-1, N.m, 20 degC, 68 degF, 293 K");
}

TEST(Ascii, tells_what_has_no_form) {
    EXPECT_TRUE(has_ascii_form(""));
    EXPECT_TRUE(has_ascii_form("°C / ‰?"));
    EXPECT_FALSE(has_ascii_form("船?"));
    EXPECT_FALSE(has_ascii_form("\xFC"));
}

TEST(Ascii, drops_accents_from_the_latin_blocks) {
    EXPECT_EQ(to_ascii("Ärø Čeština Łódź Şişli Œuvre Ñandú ÿ ſ"),
              "Aeroe Cestina Lodz Sisli Oeuvre Nandu y s");
    EXPECT_EQ(to_ascii("ĀāĐđĞğİıĶķĸŊŋŐőŔŕŢţŰűŴŵŶŷŸŹź"), "AaDdGgIiKkkNnOoRrTtUuWwYyYZz");
}

TEST(Ascii, marks_what_has_no_counterpart_once_per_character) {
    EXPECT_EQ(to_ascii("船 2"), "? 2");
    EXPECT_EQ(to_ascii("\xF0\x9F\x9A\xA2!"), "?!");
}

TEST(Ascii, turns_control_characters_into_blanks) {
    EXPECT_EQ(to_ascii("a\tb\r\nc\x7F"), "a b  c ");
    EXPECT_EQ(to_ascii("a\xC2\x9B"
                       "b"),
              "a b");
    EXPECT_EQ(to_ascii(std::string_view("a\0b", 3)), "a b");
}

TEST(Ascii, marks_every_byte_that_is_not_utf8) {
    EXPECT_EQ(to_ascii("\xFC"
                       "ber"),
              "?ber");
    EXPECT_EQ(to_ascii("\xC3"), "?");
    EXPECT_EQ(to_ascii("\xE2\x80"), "??");
    EXPECT_EQ(to_ascii("\xC0\xAF"), "??");
}

TEST(Ascii, shortens_with_an_ellipsis) {
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abc...");
    EXPECT_EQ(shortened("abcdefg", 2), "..");
    EXPECT_EQ(shortened("abcdefg", 0), "");
}

}  // namespace cgw::dictionary
