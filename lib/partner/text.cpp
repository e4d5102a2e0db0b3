#include "partner/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "dictionary/ascii.hpp"

namespace cgw::partner {
namespace {

constexpr std::size_t longest_comment = 160;
constexpr std::string_view harmless = " .,:;+-_=%()<>#&@!'/|^~[]";

char in_comment(char c, char before) {
    if (c == '"') {
        return '\'';
    }
    if (c == '/' && before == '/') {
        return '|';
    }
    return base::is_letter_or_digit(c) || harmless.find(c) != std::string_view::npos ? c : '_';
}

// A digit or letter behind it could be taken for a part of it: always three octal digits.
std::string octal(char c) {
    return fmt::format("\\{:03o}", static_cast<unsigned>(static_cast<unsigned char>(c)));
}

constexpr std::uint32_t not_utf8 = 0xFFFD;

// `character` is one well-formed sequence.
std::uint32_t code_point(std::string_view character) {
    constexpr unsigned continued_bits = 6;
    const auto lead = static_cast<std::uint8_t>(character.front());
    std::uint32_t value = character.size() == 1 ? lead : lead & (0x7FU >> character.size());
    for (const char next : character.substr(1)) {
        value = value << continued_bits | (static_cast<std::uint8_t>(next) & 0x3FU);
    }
    return value;
}

}  // namespace

std::string comment(std::string_view utf8) {
    constexpr std::size_t most_bytes_of_a_character = 4;
    const std::string_view read = utf8.substr(0, (longest_comment + 1) * most_bytes_of_a_character);
    std::string text = dictionary::shortened(dictionary::to_ascii(read), longest_comment);
    char before = ' ';
    for (char& c : text) {
        c = in_comment(c, before);
        before = c;
    }
    return text;
}

std::string_view cut(std::string_view utf8, std::size_t bytes) {
    std::size_t end = 0;
    while (end < utf8.size()) {
        const std::size_t length = std::max<std::size_t>(base::utf8_sequence_length(utf8.substr(end)), 1);
        if (end + length > bytes) {
            break;
        }
        end += length;
    }
    return utf8.substr(0, end);
}

std::string c_string(std::string_view utf8) {
    std::string text = "\"";
    for (const char c : utf8) {
        const bool plain = c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?';
        text += plain ? std::string(1, c) : octal(c);
    }
    return text + '"';
}

std::string python_string(std::string_view utf8) {
    std::string text = "\"";
    while (!utf8.empty()) {
        const std::size_t length = base::utf8_sequence_length(utf8);
        const char first = utf8.front();
        if (length == 1 && first >= ' ' && first <= '~' && first != '"' && first != '\\') {
            text += first;
        } else {
            text += fmt::format("\\U{:08x}", length == 0 ? not_utf8 : code_point(utf8.substr(0, length)));
        }
        utf8.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text + '"';
}

std::string real(double value) {
    std::string text = (value == 0 && std::signbit(value) ? "-" : "") + base::to_text(value);
    if (text.find_first_of(".en") == std::string::npos) {  // "inf" and "nan" are not among scalings
        text += ".0";
    }
    return text;
}

std::string lower(std::string_view ascii) {
    return base::lowered(ascii);
}

std::string upper(std::string_view ascii) {
    std::string text(ascii);
    std::transform(text.begin(), text.end(), text.begin(), base::upper);
    return text;
}

}  // namespace cgw::partner
