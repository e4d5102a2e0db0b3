// Attributes of an XML text as numbers and values.
#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "diagnostic/rules/xdd.hpp"
#include "eds/value_text.hpp"
#include "xdd/source.hpp"

namespace cgw::xdd {
namespace {

namespace rules = diagnostic::rules;
using dictionary::TypeKind;
using dictionary::TypeRow;
using dictionary::Value;
using eds::Number;

constexpr std::string_view blanks = " \t\r\n";

// Decimal, or hexadecimal behind 0x, or a formula. XML Schema has no octal numbers: zeros in front count for
// nothing.
Number parse_number(std::string_view text) {
    const bool is_negative = text.starts_with('-');
    std::string_view digits = text.substr(is_negative ? 1 : 0);
    if (digits.size() < 2 || digits.front() != '0' || !base::consists_of(digits, base::digits)) {
        return eds::parse_number(text);
    }
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    Number number = eds::parse_number(digits);
    number.negative = is_negative;
    number.loose = number.magnitude > 7;  // as an octal number it would be another one
    return number;
}

}  // namespace

void Source::refuse(pugi::xml_node element, pugi::xml_attribute attribute, std::string_view why) {
    report(rules::xdd_value, element, attribute, fmt::format("{}, which is {}", quoted(attribute), why));
}

void Source::refuse_range(pugi::xml_node element, pugi::xml_attribute attribute, const std::string& why) {
    report(rules::xdd_number_range, element, attribute, fmt::format("{}{}", quoted(attribute), why));
}

std::optional<std::uint64_t> Source::number(pugi::xml_node element, const char* name, std::uint64_t highest) {
    const pugi::xml_attribute attribute = element.attribute(name);
    const std::string_view text = base::trimmed(attribute.value(), blanks);
    if (text.empty()) {
        return std::nullopt;
    }
    const Number number = parse_number(text);
    if (number.reading == Number::Reading::none || number.node_id_relative) {
        refuse(element, attribute, "no number");
        return std::nullopt;
    }
    if (number.reading == Number::Reading::too_large || number.magnitude > highest ||
        (number.negative && number.magnitude != 0)) {
        refuse_range(element, attribute, fmt::format("; it can be 0 to {}", highest));
        return std::nullopt;
    }
    return number.magnitude;
}

std::optional<std::uint64_t> Source::hexadecimal(pugi::xml_node element, const char* name,
                                                 std::uint64_t highest) {
    const pugi::xml_attribute attribute = element.attribute(name);
    std::string_view text = base::trimmed(attribute.value(), blanks);
    if (text.empty()) {
        return std::nullopt;
    }
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
    }
    if (!base::consists_of(text, base::hexadecimal_digits)) {
        refuse(element, attribute, "no hexadecimal number");
        return std::nullopt;
    }
    const std::optional<std::int64_t> number = base::parse_integer(text, 16);
    if (!number || static_cast<std::uint64_t>(*number) > highest) {
        refuse_range(element, attribute, fmt::format("; it can be 0 to {:X}", highest));
        return std::nullopt;
    }
    return static_cast<std::uint64_t>(*number);
}

std::optional<bool> Source::flag(pugi::xml_node element, const char* name) {
    const pugi::xml_attribute attribute = element.attribute(name);
    const std::string_view text = base::trimmed(attribute.value(), blanks);
    if (text.empty()) {
        return std::nullopt;
    }
    const bool is_true = base::equal_ignoring_case(text, "true") || text == "1";
    if (!is_true && !base::equal_ignoring_case(text, "false") && text != "0") {
        refuse(element, attribute, "neither true nor false");
        return std::nullopt;
    }
    return is_true;
}

std::optional<Value> Source::numeric(pugi::xml_node element, pugi::xml_attribute attribute,
                                     const TypeRow& type) {
    const std::string_view text = base::trimmed(attribute.value(), blanks);
    if (type.kind == TypeKind::boolean &&
        (base::equal_ignoring_case(text, "true") || base::equal_ignoring_case(text, "false"))) {
        return Value{base::lower(text.front()) == 't' ? 1U : 0U};
    }
    const Number number = parse_number(text);
    if (number.reading == Number::Reading::none) {
        refuse(element, attribute, "no number");
        return std::nullopt;
    }
    if (number.loose) {
        report(rules::xdd_number_form, element, attribute,
               fmt::format("{}, which is no number of CiA 311", quoted(attribute)),
               fmt::format("it is read as {}{}", number.negative ? "-" : "", number.magnitude));
    }
    if (number.misplaced) {
        report(rules::xdd_number_form, element, attribute, quoted(attribute),
               fmt::format("write $NODEID+0x{:X}", number.magnitude));
    }
    std::optional<Value> value = eds::value_of(number, type);
    if (!value) {
        refuse_range(element, attribute, fmt::format(", which {} does not hold", type.name));
    }
    return value;
}

// As a decimal number, or the bits of it in hexadecimal.
std::optional<Value> Source::real(pugi::xml_node element, pugi::xml_attribute attribute,
                                  const TypeRow& type) {
    const std::string_view text = base::trimmed(attribute.value(), blanks);
    if (text.starts_with("0x") || text.starts_with("0X")) {
        return numeric(element, attribute, type);
    }
    const std::optional<double> number = base::parse_real(text);
    if (!number) {
        refuse(element, attribute, "no number");
        return std::nullopt;
    }
    std::optional<Value> value = eds::real_value(*number, type);
    if (!value) {
        refuse_range(element, attribute, fmt::format(", which {} does not hold", type.name));
    }
    return value;
}

std::optional<Value> Source::octets(pugi::xml_node element, pugi::xml_attribute attribute) {
    std::string_view digits = base::trimmed(attribute.value(), blanks);
    digits.remove_prefix(digits.starts_with("0x") || digits.starts_with("0X") ? 2 : 0);
    std::optional<std::string> bytes = eds::octets_of(digits);
    if (!bytes) {
        refuse(element, attribute, "not pairs of hexadecimal digits");
        return std::nullopt;
    }
    return bytes->empty() ? std::nullopt : std::optional(Value{0, false, std::move(*bytes)});
}

std::optional<Value> Source::value(pugi::xml_node element, const char* name, const TypeRow& type) {
    const pugi::xml_attribute attribute = element.attribute(name);
    const std::string_view text = attribute.value();
    const bool is_string = type.kind == TypeKind::visible_string || type.kind == TypeKind::unicode_string;
    const bool is_stated = is_string ? !attribute.empty() : !base::trimmed(text, blanks).empty();
    if (!is_stated || type.kind == TypeKind::structure) {
        return std::nullopt;
    }
    switch (type.kind) {
        case TypeKind::visible_string:
        case TypeKind::unicode_string:
            return Value{0, false, std::string(text)};
        case TypeKind::octet_string:
        case TypeKind::domain:
            return octets(element, attribute);
        case TypeKind::real:
            return real(element, attribute, type);
        default:
            return numeric(element, attribute, type);
    }
}

}  // namespace cgw::xdd
