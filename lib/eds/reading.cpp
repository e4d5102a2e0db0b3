#include "eds/reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/eds.hpp"
#include "eds/reader.hpp"
#include "eds/value_text.hpp"

namespace cgw::eds {
namespace {

namespace rules = diagnostic::rules;
using dictionary::TypeKind;
using dictionary::TypeRow;
using dictionary::Value;

constexpr std::size_t longest_quote = 60;

std::string quote(std::string_view text) {
    const bool cut = text.size() > longest_quote;
    return fmt::format("`{}{}`", base::printable(text.substr(0, longest_quote)), cut ? "..." : "");
}

}  // namespace

void Reading::report(const diagnostic::Rule& rule, const Span& span, std::string message, std::string help,
                     std::vector<diagnostic::Related> related) {
    if (++counts_[&rule] <= most_) {
        findings_.report({&rule, std::move(message), location(span), std::move(related), std::move(help)});
    }
}

void Reading::report_whole_file(const diagnostic::Rule& rule, std::string message) {
    findings_.report({&rule, std::move(message), {path_, {}}});
}

void Reading::finish() {
    for (const auto& [rule, count] : counts_) {
        if (count > most_) {
            report_whole_file(
                *rule, fmt::format("{} more findings of this kind are not told one by one", count - most_));
        }
    }
}

std::string Reading::quoted(const Section& of) const {
    const std::string_view name = document.name(of);
    return fmt::format("[{}{}]", base::printable(name.substr(0, longest_quote)),
                       name.size() > longest_quote ? "..." : "");
}

std::string Reading::quoted_value(std::uint32_t line) const {
    return fmt::format("{} is {}", base::printable(document.key(line).substr(0, longest_quote)),
                       quote(document.value(line)));
}

KeyLines Reading::key_lines(const Section& of, std::span<const KeyRow> rows) {
    KeyLines found;
    std::size_t expected = 0;  // keys mostly come in the order of the rows
    for (std::uint32_t line = of.header + 1; line < of.end; ++line) {
        if (document.lines()[line].kind != LineKind::entry) {
            continue;
        }
        const std::string_view key = document.key(line);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::size_t at = expected + i < rows.size() ? expected + i : expected + i - rows.size();
            const KeyRow& row = rows[at];
            if (row.name.size() != key.size() ||
                (row.name != key && !base::equal_ignoring_case(row.name, key))) {
                continue;
            }
            expected = at + 1 < rows.size() ? at + 1 : 0;
            std::uint32_t& place = found.at(row.id);
            if (place != 0) {
                report(rules::eds_key_twice, document.key_span(line),
                       fmt::format("{} stands in {} already; this one is not read", base::printable(key),
                                   quoted(of)),
                       "", {{location(document.key_span(place)), "the one that is read"}});
                break;
            }
            place = line;
            if (row.misspelt) {
                const auto right = std::find_if(rows.begin(), rows.end(), [&](const KeyRow& each) {
                    return each.id == row.id && !each.misspelt;
                });
                report(rules::eds_spelling, document.key_span(line),
                       fmt::format("{} is no key of CiA 306; it is read as {}", base::printable(key),
                                   right->name));
            }
            break;
        }
    }
    return found;
}

std::optional<std::uint32_t> Reading::entry_number(std::uint32_t line) const {
    constexpr std::size_t most_digits = 9;
    if (document.lines()[line].kind != LineKind::entry) {
        return std::nullopt;
    }
    const std::string_view key = document.key(line);
    if (key.empty() || key.size() > most_digits) {
        return std::nullopt;
    }
    std::uint32_t number = 0;
    for (const char c : key) {
        if (!base::is_digit(c)) {
            return std::nullopt;
        }
        number = number * 10 + static_cast<std::uint32_t>(c - '0');
    }
    return number;
}

bool Reading::complain(const Number& number, std::uint32_t line) {
    const Span span = document.value_span(line);
    if (number.reading == Number::Reading::none) {
        const std::string_view text = document.value(line);
        const bool octal = text.size() > 1 && text.front() == '0' && base::consists_of(text, base::digits);
        report(rules::eds_value, span, fmt::format("{}, which is no number", quoted_value(line)),
               octal ? "a leading 0 means octal, which has no 8 and no 9" : "");
        return false;
    }
    if (number.loose) {
        report(rules::eds_number_form, span,
               fmt::format("{}, which is no number of CiA 306", quoted_value(line)),
               fmt::format("it is read as {}0x{:X}", number.negative ? "-" : "", number.magnitude));
    }
    if (number.misplaced) {
        report(rules::eds_formula, span, fmt::format("{}", quoted_value(line)),
               fmt::format("write $NODEID+0x{:X}", number.magnitude));
    }
    return true;
}

std::optional<std::uint64_t> Reading::stated_number(std::uint32_t line, std::uint64_t highest) {
    const std::string_view text = document.value(line);
    if (text.empty()) {
        return std::nullopt;
    }
    const Number number = parse_number(text);
    if (!judge(number, line)) {
        return std::nullopt;
    }
    if (number.node_id_relative) {
        report(rules::eds_value, document.value_span(line),
               fmt::format("{}, and nothing here follows the node number", quoted_value(line)));
        return std::nullopt;
    }
    if (number.reading == Number::Reading::too_large || number.magnitude > highest ||
        (number.negative && number.magnitude != 0)) {
        report(rules::eds_number_range, document.value_span(line),
               fmt::format("{}; it can be 0 to {}", quoted_value(line), highest));
        return std::nullopt;
    }
    return number.magnitude;
}

void Reading::report_too_large(std::uint32_t line, const TypeRow& type) {
    report(rules::eds_number_range, document.value_span(line),
           fmt::format("{}, which {} does not hold", quoted_value(line), type.name));
}

void Reading::report_formula(std::uint32_t line, const TypeRow& type) {
    report(rules::eds_value, document.value_span(line),
           fmt::format("{}, and no {} follows the node number", quoted_value(line), type.name));
}

std::optional<Value> Reading::numeric(std::uint32_t line, const TypeRow& type) {
    const Number number = parse_number(document.value(line));
    if (!judge(number, line)) {
        return std::nullopt;
    }
    if (number.node_id_relative && type.kind != TypeKind::integer && type.kind != TypeKind::natural) {
        report_formula(line, type);
        return std::nullopt;
    }
    std::optional<Value> value = value_of(number, type);
    if (!value) {
        report_too_large(line, type);
    }
    return value;
}

// As a decimal number, or the bits of it in hexadecimal.
std::optional<Value> Reading::real(std::uint32_t line, const TypeRow& type) {
    const std::string_view text = document.value(line);
    if (text.starts_with("0x") || text.starts_with("0X") || text.find('$') != std::string_view::npos) {
        return numeric(line, type);
    }
    const std::optional<double> number = base::parse_real(text);
    if (!number) {
        report(rules::eds_value, document.value_span(line),
               fmt::format("{}, which is no number", quoted_value(line)));
        return std::nullopt;
    }
    std::optional<Value> value = real_value(*number, type);
    if (!value) {
        report_too_large(line, type);
    }
    return value;
}

std::optional<Value> Reading::string(std::uint32_t line, const TypeRow& type) {
    const std::string_view text = document.value(line);
    if (text.find('$') != std::string_view::npos && parse_number(text).node_id_relative) {
        report_formula(line, type);
        return std::nullopt;
    }
    return Value{0, false, std::string(text)};
}

// Pairs of hexadecimal digits; blanks between them are passed over.
std::optional<Value> Reading::octets(std::uint32_t line) {
    std::optional<std::string> bytes = octets_of(document.value(line));
    if (!bytes) {
        report(rules::eds_value, document.value_span(line),
               fmt::format("{}, which is not pairs of hexadecimal digits", quoted_value(line)));
        return std::nullopt;
    }
    if (2 * bytes->size() != document.value(line).size()) {
        report(rules::eds_number_form, document.value_span(line),
               fmt::format("{}: blanks stand between the digits", quoted_value(line)));
    }
    return Value{0, false, std::move(*bytes)};
}

std::optional<Value> Reading::structure(std::uint32_t line, const TypeRow& type) {
    report(
        rules::eds_value, document.value_span(line),
        fmt::format("{}, and {} is a record, which has no value of its own", quoted_value(line), type.name));
    return std::nullopt;
}

std::optional<Value> Reading::value(std::uint32_t line, const TypeRow& type) {
    if (line == 0 || document.value(line).empty()) {
        return std::nullopt;
    }
    switch (type.kind) {
        case TypeKind::structure:
            return structure(line, type);
        case TypeKind::real:
            return real(line, type);
        case TypeKind::domain:
            return is_number_zero(document.value(line)) ? std::nullopt : octets(line);
        case TypeKind::octet_string:
            return octets(line);
        case TypeKind::visible_string:
        case TypeKind::unicode_string:
            return string(line, type);
        default:
            return numeric(line, type);
    }
}

}  // namespace cgw::eds
