#include <fmt/format.h>

#include "partner/structured_parts.hpp"

namespace cgw::partner {
namespace {

using fmt::arg;
using signals::Signal;

constexpr unsigned byte_bits = 8;

std::string mask(const Signal& signal) {
    return fmt::format("BYTE#16#{:02X}", 1U << signal.first_bit % byte_bits);
}

std::string bool_text(bool value) {
    return value ? "TRUE" : "FALSE";
}

// TRUE is what a person would call so: the switch is on, the bit is 1.
bool true_is_1(const Signal& signal) {
    return raw_of_on(signal).value_or(1) == 1;
}

std::string value_function(const StFrame& of, const StMember& member) {
    return fmt::format(
        "FUNCTION {type}_VALUE_{name} : REAL\n"
        "VAR_INPUT\n"
        "    raw : DINT;\n"
        "END_VAR\n"
        "{type}_VALUE_{name} := DINT_TO_REAL(raw) * {factor} + {offset};\n"
        "END_FUNCTION\n\n",
        arg("type", of.type), arg("name", member.name), arg("factor", st_real(member.signal->factor)),
        arg("offset", st_real(member.signal->offset)));
}

std::string decoded(const StFrame& of, const StMember& member) {
    const Signal& signal = *member.signal;
    const unsigned byte = signal.first_bit / byte_bits;
    if (signal.is_bit()) {
        return fmt::format("pdo.{} := (data[{}] AND {}) {} BYTE#16#00;\n", member.name, byte, mask(signal),
                           true_is_1(signal) ? "<>" : "=");
    }
    const std::string word = fmt::format("{}_WORD(low := data[{}], high := data[{}], is_signed := {})",
                                         of.prefix, byte, byte + 1, bool_text(signal.is_signed));
    return member.real
               ? fmt::format("pdo.{} := {}_VALUE_{}(raw := {});\n", member.name, of.type, member.name, word)
               : fmt::format("pdo.{} := {};\n", member.name, word);
}

std::string decode_function(const StFrame& of) {
    std::string text = fmt::format(
        "(* FALSE, and pdo stays as it is, when the frame is too short. *)\n"
        "FUNCTION {type}_DECODE : BOOL\n"
        "VAR_INPUT\n"
        "    data : {prefix}_DATA;\n"
        "    length : UINT;\n"
        "END_VAR\n"
        "VAR_IN_OUT\n"
        "    pdo : {type};\n"
        "END_VAR\n"
        "{type}_DECODE := FALSE;\n"
        "IF length < UINT#{length} THEN\n"
        "    RETURN;\n"
        "END_IF;\n",
        arg("type", of.type), arg("prefix", of.prefix), arg("length", of.frame->length));
    for (const StMember& member : of.members) {
        text += decoded(of, member);
    }
    return text + fmt::format("{}_DECODE := TRUE;\nEND_FUNCTION\n\n", of.type);
}

// The number of a word into a variable of its own; FALSE is returned before anything is written.
std::string checked(const StFrame& of, const StMember& member, std::size_t number) {
    const Signal& signal = *member.signal;
    if (member.real) {
        return fmt::format(
            "IF NOT {}_RAW(value := pdo.{}, factor := {}, offset := {}, lowest := {}, highest := {},\n"
            "        is_signed := {}, raw := raw{}) THEN\n"
            "    RETURN;\n"
            "END_IF;\n",
            of.prefix, member.name, st_real(signal.factor), st_real(signal.offset), st_real(signal.minimum),
            st_real(signal.maximum), bool_text(signal.is_signed), number);
    }
    return fmt::format(
        "IF (pdo.{} < DINT#{}) OR (pdo.{} > DINT#{}) THEN\n"
        "    RETURN;\n"
        "END_IF;\n"
        "raw{} := pdo.{};\n",
        member.name, signal.is_signed ? -32768 : 0, member.name, signal.is_signed ? 32767 : 65535, number,
        member.name);
}

std::string put(const StFrame& of, const StMember& member, std::size_t number) {
    const Signal& signal = *member.signal;
    const unsigned byte = signal.first_bit / byte_bits;
    if (signal.is_bit()) {
        return fmt::format(
            "IF {}pdo.{} THEN\n"
            "    data[{}] := data[{}] OR {};\n"
            "END_IF;\n",
            true_is_1(signal) ? "" : "NOT ", member.name, byte, byte, mask(signal));
    }
    return fmt::format("data[{}] := {}_LOW(raw := raw{});\ndata[{}] := {}_HIGH(raw := raw{});\n", byte,
                       of.prefix, number, byte + 1, of.prefix, number);
}

std::string raw_variables(const StFrame& of) {
    std::string text;
    for (std::size_t i = 0; i < of.members.size(); ++i) {
        text += of.members[i].signal->is_bit() ? "" : fmt::format("    raw{} : DINT;\n", i);
    }
    return text.empty() ? text : "VAR\n" + text + "END_VAR\n";
}

std::string encode_function(const StFrame& of) {
    std::string text = fmt::format(
        "(* FALSE, and data stays as it is, when a value is beyond its range. *)\n"
        "FUNCTION {type}_ENCODE : BOOL\n"
        "VAR_INPUT\n"
        "    pdo : {type};\n"
        "END_VAR\n"
        "VAR_IN_OUT\n"
        "    data : {prefix}_DATA;\n"
        "END_VAR\n"
        "{raw}"
        "{type}_ENCODE := FALSE;\n",
        arg("type", of.type), arg("prefix", of.prefix), arg("raw", raw_variables(of)));
    for (std::size_t i = 0; i < of.members.size(); ++i) {
        text += of.members[i].signal->is_bit() ? "" : checked(of, of.members[i], i);
    }
    for (unsigned byte = 0; byte < of.frame->length; ++byte) {
        text += fmt::format("data[{}] := BYTE#16#00;\n", byte);
    }
    for (std::size_t i = 0; i < of.members.size(); ++i) {
        text += put(of, of.members[i], i);
    }
    return text + fmt::format("{}_ENCODE := TRUE;\nEND_FUNCTION\n\n", of.type);
}

}  // namespace

std::string st_functions(const StFrame& of) {
    std::string text;
    for (const StMember& member : of.members) {
        text += member.real ? value_function(of, member) : "";
    }
    return text + decode_function(of) + (of.frame->transmit() ? "" : encode_function(of));
}

}  // namespace cgw::partner
