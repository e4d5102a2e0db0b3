#include <fmt/format.h>

#include "partner/c_parts.hpp"
#include "partner/text.hpp"
#include "signals/codec.hpp"
#include "signals/comment.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;
using signals::Signal;

constexpr unsigned byte_bits = 8;

std::string macro(const CFrame& of, std::string_view what, const Signal& signal, const std::string& value) {
    return fmt::format("#define {}_{}_{} {}\n", of.macro, what, signal.name, value);
}

std::string number(double value) {
    const std::string text = real(value);
    return text.starts_with('-') ? "(" + text + ")" : text;
}

std::string number(std::int32_t value) {
    return value < 0 ? fmt::format("({})", value) : fmt::format("{}", value);
}

std::string macros(const CFrame& of, const Signal& signal) {
    std::string text = macro(of, "BYTE", signal, fmt::format("{}u", signal.first_bit / byte_bits)) +
                       macro(of, "RAWMIN", signal, number(signal.raw_minimum)) +
                       macro(of, "RAWMAX", signal, number(signal.raw_maximum));
    if (signal.scaled) {
        text += macro(of, "UNIT", signal, c_string(cut(signal.unit, longest_unit))) +
                macro(of, "FACTOR", signal, number(signal.factor)) +
                macro(of, "OFFSET", signal, number(signal.offset)) +
                macro(of, "MIN", signal, number(signal.minimum)) +
                macro(of, "MAX", signal, number(signal.maximum));
    }
    return text;
}

// Raw values, and physical ones where the scaling is known.
constexpr std::string_view reading =
    "static inline int32_t {type}_raw_{name}(const {type} *pdo)\n"
    "{{\n"
    "    return {prefix}_word{sign}(pdo->bytes + {macro}_BYTE_{name});\n"
    "}}\n";
constexpr std::string_view reading_scaled =
    "static inline double {type}_value_{name}(const {type} *pdo)\n"
    "{{\n"
    "    return (double){type}_raw_{name}(pdo) * {macro}_FACTOR_{name} + {macro}_OFFSET_{name};\n"
    "}}\n";
constexpr std::string_view writing =
    "static inline void {type}_setraw_{name}({type} *pdo, int32_t raw)\n"
    "{{\n"
    "    {prefix}_putword(pdo->bytes + {macro}_BYTE_{name}, raw);\n"
    "}}\n";
constexpr std::string_view writing_scaled =
    "static inline int {type}_set_{name}({type} *pdo, double value)\n"
    "{{\n"
    "    return {prefix}_putvalue(pdo->bytes + {macro}_BYTE_{name}, value, {macro}_FACTOR_{name},\n"
    "                          {macro}_OFFSET_{name}, {macro}_MIN_{name}, {macro}_MAX_{name}, {signed});\n"
    "}}\n";

std::string functions(const CFrame& of, const Signal& signal) {
    const auto written = [&](std::string_view text) {
        return fmt::format(fmt::runtime(text), arg("type", of.type), arg("macro", of.macro),
                           arg("prefix", of.prefix), arg("name", signal.name),
                           arg("sign", signal.is_signed ? "_signed" : ""),
                           arg("signed", signal.is_signed ? 1 : 0));
    };
    std::string text = written(reading) + (signal.scaled ? written(reading_scaled) : "");
    if (!of.frame.transmit()) {
        text += written(writing) + (signal.scaled ? written(writing_scaled) : "");
    }
    return text;
}

// On and off instead of 1 and 0: some switches are low-active.
std::string switch_functions(const CFrame& of, const Signal& signal) {
    const int on = raw_of_on(signal).value_or(1);
    return fmt::format(
        "static inline int {type}_ison_{name}(const {type} *pdo)\n"
        "{{\n"
        "    return {type}_bit(pdo, {bit}u) == {on};\n"
        "}}\n"
        "static inline void {type}_turn_{name}({type} *pdo, int on)\n"
        "{{\n"
        "    {type}_putbit(pdo, {bit}u, on ? {on} : {off});\n"
        "}}\n",
        arg("type", of.type), arg("name", signal.name), arg("bit", signal.first_bit), arg("on", on),
        arg("off", 1 - on));
}

std::string bit_functions(const CFrame& of) {
    std::string text = fmt::format(
        "static inline int {type}_bit(const {type} *pdo, unsigned bit)\n"
        "{{\n"
        "    return bit / 8u < {macro}_LENGTH ? pdo->bytes[bit / 8u] >> (bit % 8u) & 1 : 0;\n"
        "}}\n",
        arg("type", of.type), arg("macro", of.macro));
    if (!of.frame.transmit()) {
        text += fmt::format(
            "static inline void {type}_putbit({type} *pdo, unsigned bit, int value)\n"
            "{{\n"
            "    if (bit / 8u < {macro}_LENGTH) {{\n"
            "        unsigned mask = 1u << (bit % 8u);\n"
            "        unsigned rest = pdo->bytes[bit / 8u] & ~mask;\n"
            "        pdo->bytes[bit / 8u] = (uint8_t)(value ? rest | mask : rest);\n"
            "    }}\n"
            "}}\n",
            arg("type", of.type), arg("macro", of.macro));
    }
    return text;
}

std::string enumerators(const CFrame& of) {
    std::string text;
    for (const Signal& signal : of.frame.signals) {
        if (signal.is_bit()) {
            text +=
                fmt::format("{}    /* {} */\n    {}_BIT_{} = {}", text.empty() ? "" : ",\n",
                            comment(signals::comment_of(signal)), of.macro, signal.name, signal.first_bit);
        }
    }
    return text;
}

}  // namespace

std::string c_word(const CFrame& of, const Signal& signal) {
    return fmt::format("\n/* {}: {}; {} */\n", signal.name, comment(signals::comment_of(signal)),
                       signal.scaled ? comment(signals::scaling_text(signal)) : "scaling not known") +
           macros(of, signal) + functions(of, signal);
}

std::string c_bits(const CFrame& of) {
    const std::string listed = enumerators(of);
    if (listed.empty()) {
        return {};
    }
    std::string text =
        fmt::format("\n/* Bits of {}, counted from the lowest of byte 0. */\nenum {{\n{}\n}};\n",
                    of.frame.name, listed) +
        bit_functions(of);
    for (const Signal& signal : of.frame.signals) {
        text += raw_of_on(signal) ? switch_functions(of, signal) : "";
    }
    return text;
}

}  // namespace cgw::partner
