#include "eds/number.hpp"

#include <array>
#include <limits>

#include "base/ascii.hpp"

namespace cgw::eds {
namespace {

constexpr std::string_view node_id = "$NODEID";

bool has_hexadecimal_prefix(std::string_view text) {
    return text.size() > 2 && text[0] == '0' && base::lower(text[1]) == 'x';
}

// Of a number in the language C.
bool is_suffix(char c) {
    return base::lower(c) == 'u' || base::lower(c) == 'l';
}

// Of a character, the digit that it is; 255: none.
constexpr auto digits_by_character = [] {
    std::array<std::uint8_t, 0x100> digits{};
    digits.fill(0xFF);
    for (std::uint8_t digit = 0; digit < 16; ++digit) {
        const char c = "0123456789abcdef"[digit];
        digits[static_cast<std::uint8_t>(c)] = digit;
        digits[static_cast<std::uint8_t>(c >= 'a' ? c - 'a' + 'A' : c)] = digit;
    }
    return digits;
}();

void read_digits(std::string_view digits, std::uint64_t radix, Number& number) {
    number.reading = digits.empty() ? Number::Reading::none : Number::Reading::number;
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t room = most / radix;  // below it every digit fits
    for (const char c : digits) {
        const std::uint64_t digit = digits_by_character[static_cast<std::uint8_t>(c)];
        if (digit >= radix) {
            number.reading = Number::Reading::none;
            return;
        }
        if (number.magnitude >= room && (number.magnitude > room || digit > most - room * radix)) {
            number.reading = Number::Reading::too_large;  // and still no number, should a letter follow
        } else {
            number.magnitude = number.magnitude * radix + digit;
        }
    }
}

// Of one digit, or of 0x and up to sixteen, which nearly all numbers are; false for all others.
bool is_plain(std::string_view text, std::uint64_t& magnitude) {
    if (text.size() == 1 && base::is_digit(text.front())) {
        magnitude = static_cast<std::uint64_t>(text.front() - '0');
        return true;
    }
    constexpr std::size_t longest = 18;
    if (text.size() > longest || !has_hexadecimal_prefix(text)) {
        return false;
    }
    std::uint8_t odd = 0;  // has a high bit when one of them is no digit
    for (const char c : text.substr(2)) {
        const std::uint8_t digit = digits_by_character[static_cast<std::uint8_t>(c)];
        odd |= digit;
        magnitude = magnitude << 4U | digit;
    }
    return odd < 16;
}

Number parse_literal(std::string_view text) {
    Number number;
    if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
        number.negative = text.front() == '-';
        number.loose = text.front() == '+';
        text.remove_prefix(1);
    }
    std::uint64_t radix = 10;
    if (has_hexadecimal_prefix(text)) {
        radix = 16;
        text.remove_prefix(2);
        while (has_hexadecimal_prefix(text)) {
            number.loose = true;
            text.remove_prefix(2);
        }
    } else if (text.size() > 1 && text.front() == '0') {
        radix = 8;
    }
    while (text.size() > 1 && is_suffix(text.back())) {
        number.loose = true;
        text.remove_suffix(1);
    }
    read_digits(text, radix, number);
    return number;
}

// The terms of a sum, of which one is the node number.
Number parse_formula(std::string_view text) {
    Number sum;
    sum.reading = Number::Reading::number;
    std::size_t terms = 0;
    for (bool first = true;; first = false) {
        const std::size_t plus = text.find('+');
        const std::string_view part = text.substr(0, plus);
        const std::string_view term = base::trimmed(part);
        const bool is_node_id = base::equal_ignoring_case(term, node_id);
        sum.misplaced |= term.size() != part.size() || is_node_id != first ||
                         (is_node_id && term != node_id) || ++terms > 2;
        const Number number = is_node_id ? Number{.reading = Number::Reading::number} : parse_literal(term);
        if (number.reading == Number::Reading::none || number.negative ||
            (is_node_id && sum.node_id_relative)) {
            return {};
        }
        sum.node_id_relative |= is_node_id;
        sum.loose |= number.loose;
        if (number.reading == Number::Reading::too_large ||
            number.magnitude > std::numeric_limits<std::uint64_t>::max() - sum.magnitude) {
            sum.reading = Number::Reading::too_large;
        }
        sum.magnitude += number.magnitude;
        if (plus == std::string_view::npos) {
            return sum.node_id_relative ? sum : Number{};
        }
        text.remove_prefix(plus + 1);
    }
}

}  // namespace

Number parse_number(std::string_view text) {
    Number plain{.reading = Number::Reading::number};
    if (is_plain(text, plain.magnitude)) {
        return plain;
    }
    const Number literal = parse_literal(text);
    const bool is_formula =
        literal.reading == Number::Reading::none && text.find('$') != std::string_view::npos;
    return is_formula ? parse_formula(text) : literal;
}

}  // namespace cgw::eds
