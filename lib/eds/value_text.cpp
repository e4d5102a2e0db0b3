#include "eds/value_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <iterator>

#include "base/ascii.hpp"
#include "base/numbers.hpp"

namespace cgw::eds {
namespace {

using dictionary::TypeKind;
using dictionary::TypeRow;
using dictionary::Value;

std::uint64_t mask_of(unsigned bits) {
    return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

bool fits(const Number& number, const TypeRow& type) {
    if (!number.negative) {
        return number.magnitude <= mask_of(type.bits);
    }
    return type.kind == TypeKind::integer ? number.magnitude <= std::uint64_t{1} << (type.bits - 1)
                                          : number.magnitude == 0;
}

std::string hexadecimal(std::uint64_t number, const TypeRow& type) {
    const unsigned bytes = (type.bits + 7) / 8;
    return fmt::format("0x{:0{}X}", number & mask_of(8 * bytes), 2 * bytes);
}

// Importers take 0xFF of a signed type for 255, or for too much.
bool is_negative(std::uint64_t number, const TypeRow& type) {
    return type.kind == TypeKind::integer && (number >> (type.bits - 1) & 1U) != 0;
}

std::string real_text(std::uint64_t bits, const TypeRow& type) {
    if (type.bits == 64) {
        const auto number = std::bit_cast<double>(bits);
        return std::isfinite(number) ? fmt::format("{}", number) : hexadecimal(bits, type);
    }
    const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (!std::isfinite(number)) {
        return hexadecimal(bits, type);
    }
    // The shortest text, unless it is rounded twice on its way back.
    std::string text = fmt::format("{}", number);
    const std::optional<double> again = base::parse_real(text);
    return again && static_cast<float>(*again) == number ? text : fmt::format("{}", double{number});
}

std::string octets_text(std::string_view bytes) {
    std::string text;
    text.reserve(2 * bytes.size());
    for (const char byte : bytes) {
        fmt::format_to(std::back_inserter(text), "{:02X}", static_cast<unsigned char>(byte));
    }
    return text;
}

}  // namespace

std::string value_text(const Value& value, const TypeRow& type) {
    if (value.node_id_relative) {
        return fmt::format("$NODEID+0x{:X}", value.number);
    }
    switch (type.kind) {
        case TypeKind::structure:
            return "";
        case TypeKind::octet_string:
        case TypeKind::domain:
            return octets_text(value.bytes);
        case TypeKind::visible_string:
        case TypeKind::unicode_string:
            return value.bytes;
        case TypeKind::real:
            return real_text(value.number, type);
        default:
            return is_negative(value.number, type)
                       ? fmt::format("-{}", (~value.number + 1) & mask_of(type.bits))
                       : hexadecimal(value.number, type);
    }
}

std::optional<Value> value_of(const Number& number, const TypeRow& type) {
    if (number.reading != Number::Reading::number || !fits(number, type)) {
        return std::nullopt;
    }
    const std::uint64_t bits = number.negative ? ~number.magnitude + 1 : number.magnitude;
    return Value{bits & mask_of(type.bits), number.node_id_relative};
}

std::optional<Value> real_value(double number, const TypeRow& type) {
    if (type.bits == 64) {
        return Value{std::bit_cast<std::uint64_t>(number)};
    }
    const auto narrow = static_cast<float>(number);
    return std::isfinite(narrow) ? std::optional(Value{std::bit_cast<std::uint32_t>(narrow)}) : std::nullopt;
}

bool is_number_zero(std::string_view text) {
    const Number number = parse_number(text);
    return (text.size() == 1 || base::lower(text.substr(0, 2).back()) == 'x') && !number.negative &&
           number.reading == Number::Reading::number && number.magnitude == 0 && !number.node_id_relative;
}

std::optional<std::string> octets_of(std::string_view text) {
    std::string digits(text);
    std::erase(digits, ' ');
    if (digits.size() % 2 != 0 || (!digits.empty() && !base::consists_of(digits, base::hexadecimal_digits))) {
        return std::nullopt;
    }
    std::string bytes;
    bytes.reserve(digits.size() / 2);
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        bytes += static_cast<char>(*base::parse_integer(std::string_view(digits).substr(i, 2), 16));
    }
    return bytes;
}

}  // namespace cgw::eds
