#include "toml/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <sstream>
#include <toml.hpp>

#include "base/numbers.hpp"
#include "diagnostic/rules/files.hpp"

namespace cgw::toml {
namespace {

using Value = ::toml::value;

bool agrees(const Value& value, const Node& node);

bool tables_agree(const Value& value, const Node& node) {
    const auto& table = value.as_table();
    return table.size() == node.entries.size() &&
           std::all_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) {
               const auto found = table.find(entry.key);
               return found != table.end() && agrees(found->second, entry.value);
           });
}

bool arrays_agree(const Value& value, const Node& node) {
    const auto& array = value.as_array();
    return std::equal(array.begin(), array.end(), node.elements.begin(), node.elements.end(), agrees);
}

bool agrees(const Value& value, const Node& node) {
    switch (node.kind) {
        case Kind::string:
            return value.is_string() && value.as_string().str == node.text;
        case Kind::integer:
            return value.is_integer() &&
                   (node.notation == Notation::binary || value.as_integer() == node.integer);
        case Kind::real:
            return value.is_floating();
        case Kind::boolean:
            return value.is_boolean() && value.as_boolean() == node.boolean;
        case Kind::local_date:
            return value.is_local_date();
        case Kind::other_time:
            return value.is_local_time() || value.is_local_datetime() || value.is_offset_datetime();
        case Kind::array:
            return value.is_array() && arrays_agree(value, node);
        case Kind::table:
            return value.is_table() && tables_agree(value, node);
    }
    return false;
}

// The parser explains itself in several lines: the reason, then excerpts "NN | the line" with a mark below.
// The last excerpt is where it stopped.
Complaint from_explanation(std::string_view explanation) {
    Complaint complaint;
    complaint.where = {{1, 1}, {1, 2}};
    std::string_view reason = explanation.substr(0, explanation.find('\n'));
    if (reason.starts_with("[error] ")) {
        reason.remove_prefix(8);
    }
    if (reason.starts_with("toml::")) {
        reason.remove_prefix(std::min(reason.find(": ") + 2, reason.size()));
    }
    complaint.message = fmt::format("not valid TOML: {}", reason);
    while (!explanation.empty()) {
        const std::size_t end = std::min(explanation.find('\n'), explanation.size());
        const std::string_view line = explanation.substr(0, end);
        explanation.remove_prefix(std::min(end + 1, explanation.size()));
        const std::size_t bar = line.find(" | ");
        const std::size_t first = line.find_first_not_of(' ');
        if (bar == std::string_view::npos || first >= bar) {
            continue;
        }
        const auto number = base::parse_integer(line.substr(first, bar - first));
        const std::size_t mark = explanation.find_first_not_of(' ', bar + 3);
        if (number && mark != std::string_view::npos) {
            const auto column = static_cast<std::uint32_t>(mark - bar - 2);
            const auto line_number = static_cast<std::uint32_t>(*number);
            complaint.where = {{line_number, column}, {line_number, column + 1}};
        }
    }
    return complaint;
}

}  // namespace

std::optional<Complaint> judge(const std::string& text, const Node& document) {
    try {
        std::istringstream stream(text);
        if (agrees(::toml::parse(stream, "file"), document)) {
            return std::nullopt;
        }
    } catch (const std::exception& error) {
        return from_explanation(error.what());
    }
    return Complaint{&diagnostic::rules::toml_syntax,
                     {{1, 1}, {1, 2}},
                     "the file can be read in two ways",
                     "simplify it: keys and strings without escape sequences, one key per line"};
}

}  // namespace cgw::toml
