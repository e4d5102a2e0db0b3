#include "toml/literal.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "base/ascii.hpp"
#include "base/numbers.hpp"

namespace cgw::toml {
namespace {

bool is_digit_of(char c, int base) {
    if (base <= 10) {
        return c >= '0' && c < '0' + base;
    }
    return base::is_hexadecimal_digit(c);
}

// Digits with single underscores between them.
bool is_digits(std::string_view text, int base) {
    bool after_digit = false;
    for (const char c : text) {
        if (c == '_' && !after_digit) {
            return false;
        }
        if (c != '_' && !is_digit_of(c, base)) {
            return false;
        }
        after_digit = c != '_';
    }
    return after_digit;
}

bool is_decimal_integer(std::string_view text) {
    return is_digits(text, 10) && (text.size() == 1 || text.front() != '0');
}

std::string_view without_sign(std::string_view text) {
    return text.starts_with('+') || text.starts_with('-') ? text.substr(1) : text;
}

std::string without_underscores(std::string_view text) {
    std::string result(text);
    std::erase(result, '_');
    return result;
}

struct Prefix {
    std::string_view text;
    int base;
    Notation notation;
};

constexpr Prefix prefixes[] = {
    {"0x", 16, Notation::hexadecimal}, {"0o", 8, Notation::octal}, {"0b", 2, Notation::binary}};

Literal integer(std::string_view digits, int radix, Notation notation) {
    Literal result;
    result.node.kind = Kind::integer;
    result.node.notation = notation;
    const auto value = base::parse_integer(without_underscores(digits), radix);
    result.verdict = value ? Verdict::ok : Verdict::out_of_range;
    result.node.integer = value.value_or(0);
    result.node.real = static_cast<double>(result.node.integer);
    return result;
}

bool is_real(std::string_view unsigned_text) {
    const std::size_t exponent = unsigned_text.find_first_of("eE");
    std::string_view mantissa = unsigned_text.substr(0, exponent);
    if (exponent != std::string_view::npos &&
        !is_digits(without_sign(unsigned_text.substr(exponent + 1)), 10)) {
        return false;
    }
    const std::size_t point = mantissa.find('.');
    if (point != std::string_view::npos && !is_digits(mantissa.substr(point + 1), 10)) {
        return false;
    }
    const bool has_part = exponent != std::string_view::npos || point != std::string_view::npos;
    return has_part && is_decimal_integer(mantissa.substr(0, point));
}

Literal real(std::string_view token) {
    Literal result;
    result.node.kind = Kind::real;
    const std::string_view magnitude = without_sign(token);
    if (magnitude == "inf" || magnitude == "nan") {
        result.verdict = Verdict::ok;
        result.node.real = magnitude == "inf" ? std::numeric_limits<double>::infinity()
                                              : std::numeric_limits<double>::quiet_NaN();
        if (token.front() == '-') {
            result.node.real = -result.node.real;
        }
        return result;
    }
    if (is_real(magnitude)) {
        const auto value = base::parse_real(without_underscores(token));
        result.verdict = value ? Verdict::ok : Verdict::out_of_range;
        result.node.real = value.value_or(0);
    }
    return result;
}

// `pattern` has d for a digit; anything else stands for itself.
bool matches(std::string_view text, std::string_view pattern) {
    return text.size() >= pattern.size() &&
           std::equal(pattern.begin(), pattern.end(), text.begin(), [](char expected, char c) {
               return expected == 'd' ? base::is_digit(c) : expected == c;
           });
}

int two_digits(std::string_view text) {
    return (text[0] - '0') * 10 + (text[1] - '0');
}

bool is_date(std::string_view text) {
    if (!looks_like_date(text)) {
        return false;
    }
    const int year = two_digits(text) * 100 + two_digits(text.substr(2));
    const int month = two_digits(text.substr(5));
    const int day = two_digits(text.substr(8));
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    const std::array<int, 12> days{31, leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month >= 1 && month <= 12 && day >= 1 && day <= days[static_cast<std::size_t>(month - 1)];
}

// Consumes hh:mm:ss with an optional fraction; false when it is not one.
bool consume_time(std::string_view& text) {
    if (!matches(text, "dd:dd:dd") || two_digits(text) > 23 || two_digits(text.substr(3)) > 59 ||
        two_digits(text.substr(6)) > 60) {
        return false;
    }
    text.remove_prefix(8);
    if (text.starts_with('.')) {
        const std::size_t end = std::min(text.find_first_not_of("0123456789", 1), text.size());
        if (end == 1) {
            return false;
        }
        text.remove_prefix(end);
    }
    return true;
}

bool is_offset(std::string_view text) {
    if (text == "Z" || text == "z") {
        return true;
    }
    return text.size() == 6 && (matches(text, "+dd:dd") || matches(text, "-dd:dd")) &&
           two_digits(text.substr(1)) <= 23 && two_digits(text.substr(4)) <= 59;
}

Literal date_or_time(std::string_view token) {
    Literal result;
    result.node.kind = Kind::other_time;
    std::string_view rest = token;
    if (looks_like_date(token)) {
        if (!is_date(token)) {
            return result;
        }
        if (token.size() == 10) {
            result.node.kind = Kind::local_date;
            result.verdict = Verdict::ok;
            return result;
        }
        rest.remove_prefix(11);
        const bool ok = std::string_view("Tt ").find(token[10]) != std::string_view::npos &&
                        consume_time(rest) && (rest.empty() || is_offset(rest));
        result.verdict = ok ? Verdict::ok : Verdict::not_a_value;
        return result;
    }
    result.verdict = consume_time(rest) && rest.empty() ? Verdict::ok : Verdict::not_a_value;
    return result;
}

Literal classify(std::string_view token) {
    if (token == "true" || token == "false") {
        Literal result;
        result.verdict = Verdict::ok;
        result.node.kind = Kind::boolean;
        result.node.boolean = token == "true";
        return result;
    }
    for (const Prefix& prefix : prefixes) {
        if (token.starts_with(prefix.text)) {
            const std::string_view digits = token.substr(prefix.text.size());
            return is_digits(digits, prefix.base) ? integer(digits, prefix.base, prefix.notation) : Literal{};
        }
    }
    if (is_decimal_integer(without_sign(token))) {
        return integer(token, 10, Notation::decimal);
    }
    if (looks_like_date(token) || matches(token, "dd:")) {
        return date_or_time(token);
    }
    return real(token);
}

}  // namespace

bool looks_like_date(std::string_view token) {
    return matches(token, "dddd-dd-dd");
}

Literal read_literal(std::string_view token) {
    Literal result = classify(token);
    result.node.text = token;
    return result;
}

}  // namespace cgw::toml
