#include "dictionary/ascii.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/utf8.hpp"

namespace cgw::dictionary {
namespace {

struct Spelling {
    char32_t character;
    std::string_view text;
};

// What is longer than one letter, or no letter at all; the blocks below hold the rest.
constexpr std::array spellings{
    Spelling{0x00A0, " "},        Spelling{0x00B0, "deg"},   Spelling{0x00B1, "+/-"},
    Spelling{0x00B2, "2"},        Spelling{0x00B3, "3"},     Spelling{0x00B5, "u"},
    Spelling{0x00B7, "."},        Spelling{0x00B9, "1"},     Spelling{0x00C4, "Ae"},
    Spelling{0x00C5, "Aa"},       Spelling{0x00C6, "Ae"},    Spelling{0x00D6, "Oe"},
    Spelling{0x00D8, "Oe"},       Spelling{0x00DC, "Ue"},    Spelling{0x00DE, "Th"},
    Spelling{0x00DF, "ss"},       Spelling{0x00E4, "ae"},    Spelling{0x00E5, "aa"},
    Spelling{0x00E6, "ae"},       Spelling{0x00F6, "oe"},    Spelling{0x00F8, "oe"},
    Spelling{0x00FC, "ue"},       Spelling{0x00FE, "th"},    Spelling{0x0152, "Oe"},
    Spelling{0x0153, "oe"},       Spelling{0x0394, "Delta"}, Spelling{0x03A9, "Ohm"},
    Spelling{0x03BC, "u"},        Spelling{0x2010, "-"},     Spelling{0x2011, "-"},
    Spelling{0x2013, "-"},        Spelling{0x2014, "-"},     Spelling{0x2018, "'"},
    Spelling{0x2019, "'"},        Spelling{0x201A, "'"},     Spelling{0x201C, "\""},
    Spelling{0x201D, "\""},       Spelling{0x201E, "\""},    Spelling{0x2026, "..."},
    Spelling{0x2030, "permille"}, Spelling{0x207B, "-"},     Spelling{0x20AC, "EUR"},
    Spelling{0x2103, "degC"},     Spelling{0x2109, "degF"},  Spelling{0x2126, "Ohm"},
    Spelling{0x212A, "K"},        Spelling{0x2212, "-"},     Spelling{0x22C5, "."},
};

// U+00C0 to U+017F, one letter each.
constexpr char32_t first_letter = 0x00C0;
constexpr std::string_view letters =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiJjJjKkkLlLlLlLlLl"
    "NnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
static_assert(first_letter + letters.size() == 0x0180);

constexpr char32_t not_utf8 = 0xFFFD;
constexpr char no_counterpart = '?';

constexpr bool is_printable_ascii(char32_t character) {
    constexpr char32_t del = 0x7F;
    return character >= ' ' && character < del;
}

// Takes one character off the front of `text`, which is not empty.
char32_t take_character(std::string_view& text) {
    const std::size_t length = std::max<std::size_t>(base::utf8_sequence_length(text), 1);
    const auto lead = static_cast<std::uint8_t>(text.front());
    char32_t character = length == 1 ? lead : lead & (0x7FU >> length);
    for (const char next : text.substr(1, length - 1)) {
        character = (character << 6U) | (static_cast<std::uint8_t>(next) & 0x3FU);
    }
    text.remove_prefix(length);
    return length == 1 && lead >= 0x80 ? not_utf8 : character;
}

// What is no printable ASCII.
void append_spelt(std::string& ascii, char32_t character) {
    constexpr char32_t first_after_controls = 0xA0;
    const auto* const special = std::find_if(spellings.begin(), spellings.end(),
                                             [&](const Spelling& row) { return row.character == character; });
    if (character < first_after_controls) {
        ascii += ' ';
    } else if (special != spellings.end()) {
        ascii += special->text;
    } else if (character >= first_letter && character - first_letter < letters.size()) {
        ascii += letters[character - first_letter];
    } else {
        ascii += no_counterpart;
    }
}

}  // namespace

bool has_ascii_form(std::string_view utf8) {
    const auto marks = [](std::string_view text) {
        return std::count(text.begin(), text.end(), no_counterpart);
    };
    return marks(to_ascii(utf8)) == marks(utf8);
}

std::string to_ascii(std::string_view utf8) {
    std::string ascii;
    ascii.reserve(utf8.size());
    while (!utf8.empty()) {
        if (const char c = utf8.front(); is_printable_ascii(static_cast<unsigned char>(c))) {
            ascii += c;
            utf8.remove_prefix(1);
        } else {
            append_spelt(ascii, take_character(utf8));
        }
    }
    return ascii;
}

std::string shortened(std::string_view ascii, std::size_t length) {
    constexpr std::string_view ellipsis = "...";
    if (ascii.size() <= length) {
        return std::string(ascii);
    }
    const std::size_t kept = length > ellipsis.size() ? length - ellipsis.size() : 0;
    return std::string(ascii.substr(0, kept)) + std::string(ellipsis.substr(0, length - kept));
}

}  // namespace cgw::dictionary
