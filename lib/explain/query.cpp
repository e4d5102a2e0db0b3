#include "explain/query.hpp"

#include <algorithm>
#include <string>

#include "base/ascii.hpp"
#include "base/numbers.hpp"

namespace cgw::explain {

namespace {

bool has_prefix(std::string_view text, std::string_view letters) {
    return text.size() > 2 && text[0] == '0' && letters.find(text[1]) != std::string_view::npos;
}

// Digits of `base` only, no sign, at most `highest`.
std::optional<std::uint32_t> parse_digits(std::string_view text, int base, std::uint32_t highest) {
    const bool plain = base::consists_of(text, base::hexadecimal_digits);
    const auto value = plain ? base::parse_integer(text, base) : std::nullopt;
    return value && *value <= highest ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

// "0x2005" or "2005h"; plain digits are no hexadecimal number.
std::optional<std::uint32_t> parse_hexadecimal(std::string_view text, std::uint32_t highest) {
    constexpr int hexadecimal = 16;
    if (has_prefix(text, "xX")) {
        return parse_digits(text.substr(2), hexadecimal, highest);
    }
    if (text.ends_with('h') || text.ends_with('H')) {
        return parse_digits(text.substr(0, text.size() - 1), hexadecimal, highest);
    }
    return std::nullopt;
}

std::optional<ObjectName> make_object(std::optional<std::uint32_t> index, std::optional<std::uint32_t> sub) {
    if (!index || !sub) {
        return std::nullopt;
    }
    return ObjectName{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
}

constexpr std::uint32_t highest_index = 0xFFFF;
constexpr std::uint32_t highest_sub = 0xFF;
constexpr std::uint32_t highest_number = 0xFFFFFFFF;
constexpr int decimal = 10;

}  // namespace

std::optional<ObjectName> parse_object(std::string_view text) {
    if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
        const std::string_view sub = text.substr(colon + 1);
        const auto number = parse_digits(sub, decimal, highest_sub);
        return make_object(parse_hexadecimal(text.substr(0, colon), highest_index),
                           number ? number : parse_hexadecimal(sub, highest_sub));
    }
    if (const auto index = parse_hexadecimal(text, highest_index)) {
        return ObjectName{static_cast<std::uint16_t>(*index), std::nullopt};
    }
    if (const std::size_t h = text.find_first_of("hH"); h != std::string_view::npos) {
        return make_object(parse_hexadecimal(text.substr(0, h + 1), highest_index),
                           parse_digits(text.substr(h + 1), decimal, highest_sub));
    }
    return std::nullopt;
}

std::optional<std::uint32_t> parse_abort_code(std::string_view text) {
    std::string digits;
    std::copy_if(text.begin(), text.end(), std::back_inserter(digits), [](char c) { return c != ' '; });
    constexpr std::size_t length = 8;
    const std::size_t marks = has_prefix(digits, "xX") ? 2 : 1;
    return digits.size() == length + marks ? parse_hexadecimal(digits, 0xFFFFFFFF) : std::nullopt;
}

std::optional<std::uint16_t> parse_parameter_number(std::string_view text) {
    const auto number = parse_digits(text, decimal, 0xFFFF);
    return number ? std::optional(static_cast<std::uint16_t>(*number)) : std::nullopt;
}

std::optional<std::uint32_t> parse_number(std::string_view text) {
    const auto value = parse_digits(text, decimal, highest_number);
    return value ? value : parse_hexadecimal(text, highest_number);
}

std::optional<std::uint32_t> parse_value(std::string_view text) {
    constexpr int binary = 2;
    return has_prefix(text, "bB") && !text.ends_with('h')
               ? parse_digits(text.substr(2), binary, highest_number)
               : parse_number(text);
}

std::optional<double> parse_parameter_value(std::string_view text) {
    if (const auto value = parse_value(text)) {
        return *value;
    }
    constexpr std::string_view decimal = "0123456789+-.,";
    if (text.find_first_not_of(decimal) != std::string_view::npos) {
        return std::nullopt;
    }
    std::string with_point(text);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return base::parse_real(with_point);
}

}  // namespace cgw::explain
