#include "partner/identifiers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.hpp"
#include "partner/text.hpp"

namespace cgw::partner {
namespace {

constexpr std::size_t longest_name = 32;

// clang-format off
constexpr std::array<std::string_view, 228> words{
    "ABS", "ABSTRACT", "ACOS", "ACTION", "ADD", "ADR", "AND", "AND_THEN", "ANY", "ANY_BIT", "ANY_DATE",
    "ANY_INT", "ANY_NUM", "ANY_REAL", "ARRAY", "ASIN", "AT", "ATAN", "BEGIN", "BIT", "BITADR", "BOOL", "BY",
    "BYTE", "CAL", "CALC", "CALCN", "CASE", "CD", "CEIL", "CHAR", "CLASS", "CLK", "CONCAT", "CONFIGURATION",
    "CONSTANT", "CONTINUE", "COS", "CTD", "CTU", "CTUD", "CU", "DATE", "DATE_AND_TIME", "DELETE", "DINT",
    "DIV", "DO", "DT", "DWORD", "ELSE", "ELSIF", "EN", "END_ACTION", "END_CASE", "END_CLASS",
    "END_CONFIGURATION", "END_FOR", "END_FUNCTION", "END_FUNCTION_BLOCK", "END_IF", "END_INTERFACE",
    "END_METHOD", "END_NAMESPACE", "END_PROGRAM", "END_PROPERTY", "END_REPEAT", "END_RESOURCE", "END_STEP",
    "END_STRUCT", "END_TRANSITION", "END_TYPE", "END_UNION", "END_VAR", "END_WHILE", "ENO", "EQ", "ET",
    "EXIT", "EXP", "EXPT", "EXTENDS", "FALSE", "FINAL", "FIND", "FLOOR", "FOR", "FROM", "FUNCTION",
    "FUNCTION_BLOCK", "F_EDGE", "F_TRIG", "GE", "GT", "IF", "IMPLEMENTS", "INDEXOF", "INI", "INSERT", "INT",
    "INTERFACE", "INTERNAL", "INTERVAL", "JMP", "JMPC", "JMPCN", "LD", "LDATE", "LDN", "LDT", "LE", "LEFT",
    "LEN", "LIMIT", "LINT", "LN", "LOG", "LOWER_BOUND", "LREAL", "LT", "LTIME", "LTOD", "LWORD", "MAX",
    "METHOD", "MID", "MIN", "MOD", "MOVE", "MUL", "MUX", "NAMESPACE", "NE", "NIL", "NON_RETAIN", "NOT",
    "NULL", "OF", "ON", "OR", "OR_ELSE", "OVERRIDE", "PARAMS", "PERSISTENT", "POINTER", "PRIORITY",
    "PRIVATE", "PROGRAM", "PROPERTY", "PROTECTED", "PT", "PUBLIC", "PV", "QD", "QU", "READ_ONLY",
    "READ_WRITE", "REAL", "REF", "REFERENCE", "REF_TO", "REPEAT", "REPLACE", "RESOURCE", "RET", "RETAIN",
    "RETURN", "RIGHT", "ROL", "ROR", "RS", "R_EDGE", "R_TRIG", "SEL", "SEMA", "SHL", "SHR", "SIN", "SINGLE",
    "SINT", "SIZEOF", "SQRT", "SR", "STEP", "STRING", "STRUCT", "SUB", "SUPER", "TAN", "TASK", "THEN",
    "THIS", "TIME", "TIME_OF_DAY", "TO", "TOD", "TOF", "TON", "TP", "TRANSITION", "TRUE", "TRUNC", "TYPE",
    "UDINT", "UINT", "ULINT", "UNION", "UNTIL", "USING", "USINT", "VAR", "VAR_ACCESS", "VAR_CONFIG",
    "VAR_EXTERNAL", "VAR_GLOBAL", "VAR_INPUT", "VAR_INST", "VAR_IN_OUT", "VAR_OUTPUT", "VAR_STAT",
    "VAR_TEMP", "WCHAR", "WHILE", "WITH", "WORD", "WSTRING", "XOR", "XSIZEOF"};
// clang-format on

// Underscores: none in front, single ones between; what is no letter, digit or underscore becomes one.
std::string regular(std::string_view wanted) {
    std::string name;
    for (const char c : wanted.substr(0, longest_name)) {
        if (base::is_letter_or_digit(c)) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    if (name.empty() || !base::is_letter(name.front())) {
        name.insert(0, name.empty() ? "Signal" : "S");
    }
    return name;
}

// With the ending it is no longer than allowed, and has single underscores still.
std::string joined(std::string_view name, std::string_view ending) {
    name = name.substr(0, longest_name - ending.size());
    name = name.substr(0, name.find_last_not_of('_') + 1);
    return std::string(name) + std::string(ending);
}

}  // namespace

bool Identifiers::is_free(const std::string& name) const {
    const std::string upper_case = upper(name);
    return std::find(reserved_.begin(), reserved_.end(), upper_case) == reserved_.end() &&
           taken_.count(upper_case) == 0;
}

std::string Identifiers::take(std::string_view wanted) {
    const std::string name = regular(wanted);
    std::string free = joined(name, "");
    for (std::size_t count = 2; !is_free(free); ++count) {
        free = joined(name, fmt::format("_{}", count));
    }
    taken_.insert(upper(free));
    return free;
}

std::span<const std::string_view> structured_text_words() {
    return words;
}

}  // namespace cgw::partner
