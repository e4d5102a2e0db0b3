#include "base/utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace cgw::base {
namespace {

// First byte range, length, and the allowed range of the second byte (RFC 3629, section 4).
struct Lead {
    std::uint8_t first, last;
    std::uint8_t length;
    std::uint8_t second_first, second_last;
};

constexpr Lead leads[] = {
    {0xC2, 0xDF, 2, 0x80, 0xBF}, {0xE0, 0xE0, 3, 0xA0, 0xBF}, {0xE1, 0xEC, 3, 0x80, 0xBF},
    {0xED, 0xED, 3, 0x80, 0x9F}, {0xEE, 0xEF, 3, 0x80, 0xBF}, {0xF0, 0xF0, 4, 0x90, 0xBF},
    {0xF1, 0xF3, 4, 0x80, 0xBF}, {0xF4, 0xF4, 4, 0x80, 0x8F},
};

struct CodePoints {
    std::uint32_t first, last;
};

constexpr CodePoints controls[] = {
    {0x0000, 0x001F}, {0x007F, 0x009F}, {0x061C, 0x061C}, {0x200B, 0x200F},
    {0x2028, 0x202E}, {0x2060, 0x2069}, {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB},
};

std::uint32_t code_point(std::string_view character) {
    constexpr std::uint8_t lead_masks[] = {0, 0x7F, 0x1F, 0x0F, 0x07};  // by length
    std::uint32_t value = static_cast<std::uint8_t>(character[0]) & lead_masks[character.size()];
    for (const char c : character.substr(1)) {
        value = (value << 6) | (static_cast<std::uint8_t>(c) & 0x3FU);
    }
    return value;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_sequence_length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

std::string from_latin_1(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0U | byte >> 6U);
            result += static_cast<char>(0x80U | (byte & 0x3FU));
        }
    }
    return result;
}

}  // namespace

std::size_t utf8_sequence_length(std::string_view text) {
    if (text.empty()) {
        return 0;
    }
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    if (byte(0) < 0x80) {
        return 1;
    }
    for (const Lead& lead : leads) {
        if (byte(0) < lead.first || byte(0) > lead.last) {
            continue;
        }
        if (text.size() < lead.length || byte(1) < lead.second_first || byte(1) > lead.second_last) {
            return 0;
        }
        for (std::size_t i = 2; i < lead.length; ++i) {
            if (byte(i) < 0x80 || byte(i) > 0xBF) {
                return 0;
            }
        }
        return lead.length;
    }
    return 0;
}

std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool is_control(std::string_view character) {
    const std::uint32_t value = code_point(character);
    return std::any_of(std::begin(controls), std::end(controls), [value](const CodePoints& range) {
        return value >= range.first && value <= range.last;
    });
}

bool has_control(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_sequence_length(text);
        if (length != 0 && is_control(text.substr(0, length))) {
            return true;
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return false;
}

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_sequence_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        if (length == 0 || is_control(character)) {
            result += '?';
        } else {
            result += character;
        }
        text.remove_prefix(character.size());
    }
    return result;
}

std::string to_utf8(std::string_view text) {
    return is_utf8(text) ? std::string(text) : from_latin_1(text);
}

}  // namespace cgw::base
