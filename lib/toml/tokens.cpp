#include "toml/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "toml/literal.hpp"

namespace cgw::toml {
namespace {

bool is_literal_character(char c) {
    return is_bare_key_character(c) || c == '+' || c == '.' || c == ':';
}

std::size_t end_of_run(std::string_view text, std::size_t begin) {
    while (begin < text.size() && is_literal_character(text[begin])) {
        ++begin;
    }
    return begin;
}

}  // namespace

bool is_bare_key_character(char c) {
    return base::is_letter_or_digit(c) || c == '-' || c == '_';
}

std::string_view literal_token(std::string_view text, std::size_t begin) {
    std::size_t end = end_of_run(text, begin);
    const bool is_bare_date = end - begin == 10 && looks_like_date(text.substr(begin, 10));
    const std::string_view rest = text.substr(end);
    if (is_bare_date && rest.size() > 2 && rest[0] == ' ' && base::is_digit(rest[1]) &&
        base::is_digit(rest[2])) {
        end = end_of_run(text, end + 1);
    }
    return text.substr(begin, end - begin);
}

std::string shortened(std::string_view token) {
    constexpr std::size_t longest = 40;
    return token.size() <= longest ? std::string(token) : fmt::format("{}...", token.substr(0, longest));
}

std::string advice_about(std::string_view token) {
    const bool has_sign = token.front() == '+' || token.front() == '-';
    const std::string_view digits = token.substr(has_sign ? 1 : 0);
    if (digits.starts_with('.')) {
        return "a decimal number has a digit before its point";
    }
    if (digits.empty() || !base::is_digit(digits.front())) {
        return "text stands in quotes; booleans are true and false";
    }
    if (std::all_of(digits.begin(), digits.end(), base::is_digit)) {
        return "a number has no leading zeros";
    }
    const bool is_hexadecimal = std::all_of(digits.begin(), digits.end(), [](char c) {
        return base::is_digit(c) || std::string_view("abcdefABCDEFhH").find(c) != std::string_view::npos;
    });
    return is_hexadecimal ? "a hexadecimal number begins with 0x" : "";
}

}  // namespace cgw::toml
