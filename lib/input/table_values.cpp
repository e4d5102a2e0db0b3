#include "input/table_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/keys.hpp"
#include "diagnostic/rules/tables.hpp"
#include "input/value_limits.hpp"
#include "toml/document.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using parameter::Row;

constexpr std::size_t longest_number = 15;  // digits that a double still tells apart

// A unit in one spelling: without brackets, in lower case, and as the catalogue has it.
std::string canonical_unit(std::string_view text) {
    constexpr std::pair<std::string_view, std::string_view> spellings[] = {
        {"kbits/s", "kbit/s"}, {"kbaud", "kbit/s"}, {"kbd", "kbit/s"},      {"kbps", "kbit/s"},
        {"rpm", "1/min"},      {"min-1", "1/min"},  {"sec", "s"},           {"msec", "ms"},
        {"degc", "°c"},        {"-", ""},           {"h", "hex"},           {"dez", "dec"},
        {"dezimal", "dec"},    {"decimal", "dec"},  {"hexadecimal", "hex"},
    };
    std::string unit = base::lowered(text);
    std::erase_if(unit, [](char c) { return c == '[' || c == ']' || c == ' '; });
    for (const auto& [spelling, canonical] : spellings) {
        unit = unit == spelling ? std::string(canonical) : unit;
    }
    return unit;
}

// A minus as PDF files print it.
std::string with_plain_minus(std::string_view text) {
    std::string result(text);
    for (const std::string_view minus : {"\xE2\x88\x92", "\xE2\x80\x93"}) {
        if (result.starts_with(minus)) {
            result.replace(0, minus.size(), "-");
        }
    }
    return result;
}

std::string without_leading_zeros(std::string_view number) {
    const std::size_t first = std::min(number.find_first_not_of('0'), number.size() - 1);
    return std::string(number.substr(first));
}

// A value taken apart, and what is to be said about it.
class ValueReader {
  public:
    ValueReader(const Row& row, std::string_view value, std::string_view unit)
        : row_(row), typed_(value), value_(with_plain_minus(value)), unit_(unit) {}

    ValueReading read() {
        take_unit_from_value();
        if (value_.empty()) {
            return refuse(rules::table_row, "has no value");
        }
        if (base::consists_of(unit_, "0123456789.,'")) {
            return ambiguous(fmt::format("and another number, {}, follows", unit_),
                             "write the value without thousands separators");
        }
        const bool says_hex = take_hex_marks();
        const std::string unit = canonical_unit(unit_);
        if (says_hex && unit == "dec") {
            return ambiguous(fmt::format("and the unit says {}", unit_),
                             "say once whether the digits are decimal or hexadecimal");
        }
        if (!unit.empty() && !row_.unit.empty() && unit != canonical_unit(row_.unit)) {
            return other_unit(toml::quoted(unit_));
        }
        if (says_hex) {
            return row_.unit.empty() ? read_hexadecimal() : other_unit("hexadecimal digits");
        }
        return read_decimal(unit == "dec");
    }

  private:
    ValueReading refuse(const diagnostic::Rule& rule, std::string_view what, std::string help = {}) const {
        return {std::nullopt, &rule, fmt::format("{} {}", parameter::label(row_), what), std::move(help)};
    }

    ValueReading not_a_number() const {
        return refuse(rules::table_row,
                      fmt::format("has {} for a value, which is no number", toml::quoted(typed_)));
    }

    ValueReading ambiguous(std::string_view why, std::string help) const {
        return refuse(rules::table_value_ambiguous, fmt::format("is {}, {}", typed_, why), std::move(help));
    }

    ValueReading other_unit(std::string_view found) const {
        return refuse(rules::table_unit, fmt::format("is in {}, and the table says {}", row_.unit, found),
                      fmt::format("convert the value to {}, in decimal digits", row_.unit));
    }

    ValueReading accept(double value, std::string literal) const {
        if (const std::string problem = objection(row_, value); !problem.empty()) {
            return refuse(rules::value_range, fmt::format("is {}, {}", typed_, problem));
        }
        return {TableValue{value, std::move(literal)}, nullptr, {}, {}};
    }

    // "282 Hex"
    void take_unit_from_value() {
        const std::size_t blank = value_.find(' ');
        if (blank != std::string::npos && unit_.empty() && !looks_like_number(value_.substr(blank + 1))) {
            unit_ = value_.substr(blank + 1);
            value_.resize(blank);
        }
    }

    bool take_hex_marks() {
        bool marked = canonical_unit(unit_) == "hex";
        if (marked) {
            unit_.clear();
        }
        if (value_.starts_with("0x") || value_.starts_with("0X")) {
            value_.erase(0, 2);
            marked = true;
        } else if (value_.size() > 1 && (value_.back() == 'h' || value_.back() == 'H')) {
            value_.pop_back();
            marked = true;
        }
        return marked;
    }

    ValueReading read_hexadecimal() const {
        const auto number = base::parse_integer(value_, 16);
        if (!base::consists_of(value_, base::hexadecimal_digits) || !number ||
            value_.size() > longest_number) {
            return not_a_number();
        }
        // DcDesk shows such a parameter in decimal: the mark belongs to something else, or the digits do.
        if (row_.base == parameter::Base::decimal && *number > 9) {
            const bool may_be_decimal = base::consists_of(value_, base::digits);
            return ambiguous("which is hexadecimal where DcDesk shows decimal",
                             may_be_decimal
                                 ? fmt::format("write {} or {}", *number, without_leading_zeros(value_))
                                 : fmt::format("write {}", *number));
        }
        return accept(static_cast<double>(*number), "0x" + value_);
    }

    ValueReading read_decimal(bool says_decimal) const {
        const bool is_negative = value_.starts_with('-');
        const std::string sign = is_negative ? "-" : "";
        const std::string number = value_.substr(is_negative || value_.starts_with('+') ? 1 : 0);
        if (number.size() > longest_number) {
            return not_a_number();
        }
        if (base::consists_of(number, base::digits)) {
            return read_whole(sign, number, says_decimal);
        }
        const bool may_be_hex = row_.base == parameter::Base::hexadecimal && !says_decimal;
        if (may_be_hex && base::consists_of(number, base::hexadecimal_digits) && sign.empty()) {
            return read_hexadecimal();
        }
        const std::size_t separator = number.find_first_of(".,");
        if (separator == std::string::npos || !base::consists_of(number, "0123456789.,'")) {
            return not_a_number();
        }
        return read_fraction(sign, number.substr(0, separator), number.substr(separator + 1));
    }

    ValueReading read_whole(const std::string& sign, const std::string& number, bool says_decimal) const {
        const std::string literal = without_leading_zeros(number);
        if (row_.base == parameter::Base::hexadecimal && literal.size() > 1) {
            const auto decimal = base::parse_integer(number);
            if (says_decimal) {
                return ambiguous("and decimal says the unit where DcDesk shows Hex",
                                 fmt::format("write {:X} Hex", decimal.value_or(0)));
            }
            return ambiguous(
                fmt::format("which is {}h or {:X}h", literal, decimal.value_or(0)),
                fmt::format("write {} Hex in the table, or {:X} Hex", literal, decimal.value_or(0)));
        }
        return accept(base::parse_real(sign + literal).value_or(0), sign + literal);
    }

    ValueReading read_fraction(const std::string& sign, const std::string& whole,
                               const std::string& fraction) const {
        if (!base::consists_of(whole, base::digits)) {
            return not_a_number();
        }
        if (!base::consists_of(fraction, base::digits)) {
            return fraction.empty()
                       ? not_a_number()
                       : ambiguous("with more than one separator", "write it without thousands separators");
        }
        const bool may_be_thousands = fraction.size() == 3 && whole.size() <= 3 && whole.front() != '0';
        if (may_be_thousands) {
            return ambiguous(
                fmt::format("which is {}{}{} or {}{} and a fraction", sign, whole, fraction, sign, whole),
                fmt::format("write {}{}{}, or {}{}.{}0", sign, whole, fraction, sign, whole, fraction));
        }
        if (!row_.decimal) {
            return refuse(rules::value_type, fmt::format("takes a whole number, not {}", typed_));
        }
        const std::string literal = sign + without_leading_zeros(whole) + "." + fraction;
        return accept(base::parse_real(literal).value_or(0), literal);
    }

    const Row& row_;
    std::string typed_;
    std::string value_;
    std::string unit_;
};

}  // namespace

bool looks_like_number(std::string_view text) {
    const std::string plain = with_plain_minus(text);
    const std::size_t first = !plain.empty() && (plain.front() == '-' || plain.front() == '+') ? 1 : 0;
    return first < plain.size() && plain[first] >= '0' && plain[first] <= '9';
}

ValueReading read_table_value(const Row& row, std::string_view value, std::string_view unit) {
    return ValueReader(row, value, unit).read();
}

}  // namespace cgw::input
