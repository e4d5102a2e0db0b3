#include "schema/spelling.hpp"

#include <fmt/format.h>

#include "base/ascii.hpp"
#include "base/numbers.hpp"

namespace cgw::schema {
namespace {

using parameter::Row;

constexpr std::string_view blanks = "[ \\t]*";

// "[cC][aA][nN]…"; blanks may stand before a bracket.
std::string any_case(std::string_view name) {
    std::string pattern;
    for (const char c : name) {
        if (base::is_letter(c)) {
            pattern += fmt::format("[{}{}]", base::lower(c), base::upper(c));
        } else if (c == '(') {
            pattern += " *[(]";
        } else if (c == ')' || c == '.') {
            pattern += fmt::format("[{}]", c);
        } else {
            pattern += c;
        }
    }
    return pattern;
}

bool is_first_of_array(const Row& row) {
    return row.array_first != 0 && row.array_first == row.number;
}

// "409 CanBaudrate": the number alone means the row too, unless it is another parameter's.
void add_misprints(const Row& row, const parameter::Catalogue& catalogue, std::vector<std::string>& keys) {
    for (const std::string_view misprint : row.misprints) {
        const std::size_t blank = misprint.find(' ');
        const std::string_view number = misprint.substr(0, blank);
        const auto other = static_cast<std::uint16_t>(base::parse_integer(number).value_or(0));
        const bool is_free = catalogue.find(row.device, other) == nullptr;
        const std::string name = "[ \\t]+" + any_case(misprint.substr(blank + 1));
        keys.push_back(fmt::format("{}{}", number, is_free ? fmt::format("({})?", name) : name));
    }
}

}  // namespace

std::vector<std::string> canonical_spellings(const Row& row) {
    std::vector<std::string> spellings = {fmt::format("{}", row.number)};
    const auto add = [&](std::string_view name) {
        spellings.emplace_back(name);
        spellings.push_back(fmt::format("{} {}", row.number, name));
    };
    if (is_first_of_array(row)) {
        add(array_name(row));
    }
    if (!row.name.empty()) {
        add(row.name);
    }
    return spellings;
}

std::string spelling_pattern(const Row& row, const parameter::Catalogue& catalogue) {
    if (row.name.empty()) {
        return fmt::format("^{}{}([ \\t]|$)", blanks, row.number);  // with any name (D13)
    }
    std::vector<std::string> names = {any_case(row.name)};
    if (is_first_of_array(row)) {
        names.push_back(any_case(array_name(row)));
    }
    for (const std::string_view alias : row.aliases) {
        names.push_back(any_case(alias));
    }
    std::vector<std::string> keys = {
        fmt::format("{}", row.number),
        fmt::format("({}[ \\t]+)?({})", row.number, fmt::join(names, "|")),
    };
    add_misprints(row, catalogue, keys);
    return fmt::format("^{0}({1}){0}$", blanks, fmt::join(keys, "|"));
}

}  // namespace cgw::schema
