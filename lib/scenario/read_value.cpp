#include "scenario/read_value.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/ascii.hpp"
#include "base/edit_distance.hpp"
#include "base/numbers.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/keys.hpp"
#include "facts/gateway.hpp"
#include "scenario/names.hpp"

namespace cgw::scenario {
namespace {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Node;

constexpr std::size_t longest_text = 4096;  // bytes; a path

bool wrong_type(const Reader& reader, const Node& node, const Key& key) {
    reader.report(
        rules::key_type, node.range,
        fmt::format("`{}` must be {}, not {}", key.name, to_text(key.kind), toml::to_text(node.kind)));
    return false;
}

bool in_range(const Reader& reader, const Node& node, const Key& key, double number) {
    if (std::isfinite(number) &&
        (key.minimum >= key.maximum || (number >= key.minimum && number <= key.maximum))) {
        return true;
    }
    const std::string limits =
        key.minimum < key.maximum
            ? fmt::format("outside {}..{}", base::to_text(key.minimum), base::to_text(key.maximum))
            : "no number of a scenario";
    reader.report(rules::key_value, node.range, fmt::format("`{}` is {}, {}", key.name, node.text, limits));
    return false;
}

bool read_text(const Reader& reader, const Node& node, const Key& key, Value& value) {
    if (node.kind != toml::Kind::string) {
        return wrong_type(reader, node, key);
    }
    if (node.text.empty() || node.text.size() > longest_text || base::has_control(node.text)) {
        reader.report(rules::key_value, node.range,
                      fmt::format("`{}` is empty, too long, or contains a control character", key.name));
        return false;
    }
    value.text = node.text;
    return true;
}

bool read_number(const Reader& reader, const Node& node, const Key& key, Value& value) {
    const bool is_integer = node.kind == toml::Kind::integer;
    if (!is_integer && (node.kind != toml::Kind::real || key.kind == Kind::integer)) {
        return wrong_type(reader, node, key);
    }
    if (!in_range(reader, node, key, node.real)) {
        return false;
    }
    value.number = node.real;
    value.integer = key.kind == Kind::seconds ? microseconds(node.real) : node.integer;
    return true;
}

bool read_word(const Reader& reader, const Node& node, const Key& key, Value& value) {
    if (!read_text(reader, node, key, value)) {
        return false;
    }
    std::vector<std::string_view> names;
    for (const Word& word : key.words()) {
        if (base::lowered(word.name) == base::lowered(node.text)) {
            value.integer = static_cast<std::int64_t>(names.size());
            return true;
        }
        names.push_back(word.name);
    }
    std::string help = did_you_mean(node.text, names);
    reader.report(rules::key_value, node.range,
                  fmt::format("`{}` cannot be {}", key.name, toml::quoted(node.text)),
                  help.empty() ? fmt::format("it is one of {}", fmt::join(names, ", ")) : std::move(help));
    return false;
}

// A number, or a name that is looked up later.
bool read_name(const Reader& reader, const Node& node, const Key& key, Value& value) {
    if (node.kind == toml::Kind::string) {
        return read_text(reader, node, key, value);
    }
    if (node.kind != toml::Kind::integer) {
        return wrong_type(reader, node, key);
    }
    Key limited = key;
    limited.minimum = 0;
    limited.maximum = 0xFFFF;
    return read_number(reader, node, limited, value);
}

bool read_error(const Reader& reader, const Node& node, const Key& key, Value& value) {
    if (!read_name(reader, node, key, value)) {
        return false;
    }
    if (key.kind == Kind::error_or_any && value.text == "any") {
        return true;
    }
    const bool named = node.kind == toml::Kind::string;
    const auto number =
        named ? error_by_name(value.text) : std::optional(static_cast<std::uint16_t>(value.integer));
    if (number && is_error(*number)) {
        value.integer = *number;
        return true;
    }
    reader.report(rules::key_value, node.range,
                  fmt::format("{} is no error that the gateway shows",
                              named ? toml::quoted(node.text) : fmt::format("{}", value.integer)),
                  named ? did_you_mean(node.text, error_names()) : "errors are 3000..3095 and 12411..12424");
    return false;
}

// "1018h:1", "2005h"
bool read_object(const Reader& reader, const Node& node, const Key& key, Value& value) {
    if (!read_text(reader, node, key, value)) {
        return false;
    }
    const std::string_view text = node.text;
    const std::size_t mark = text.find_first_of("hH");
    const std::string_view rest = mark == text.npos ? "" : text.substr(mark + 1);
    const bool has_sub = rest.starts_with(':');
    const auto index = base::parse_integer(text.substr(0, mark == text.npos ? 0 : mark), 16);
    const auto sub = has_sub ? base::parse_integer(rest.substr(1)) : std::optional<std::int64_t>(0);
    const bool right = index && *index >= 0 && *index <= 0xFFFF && sub && *sub >= 0 && *sub <= 0xFF &&
                       (has_sub || rest.empty());
    if (!right) {
        reader.report(rules::key_value, node.range,
                      fmt::format("{} is not written as an object", toml::quoted(node.text)),
                      "write index and sub-index as 1018h:1, or the index alone as 2005h");
        return false;
    }
    value.integer = *index << 8 | *sub;
    return true;
}

}  // namespace

void Reader::report(const diagnostic::Rule& rule, const diagnostic::Range& where, std::string message,
                    std::string help) const {
    findings.report({&rule, std::move(message), {path, where}, {}, std::move(help)});
}

std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates) {
    const std::string near = base::nearest_name(text, candidates);
    return near.empty() ? "" : fmt::format("did you mean `{}`?", near);
}

std::int64_t microseconds(double seconds) {
    return std::llround(seconds * 1e6);
}

bool read_value(const Reader& reader, const Entry& entry, const Key& key, Value& value) {
    const Node& node = entry.value;
    value.given = true;
    value.where = node.range;
    switch (key.kind) {
        case Kind::text:
            return read_text(reader, node, key, value);
        case Kind::integer:
        case Kind::number:
        case Kind::seconds:
        case Kind::tpdo:
            return read_number(reader, node, key, value);
        case Kind::boolean:
            value.integer = node.boolean ? 1 : 0;
            return node.kind == toml::Kind::boolean || wrong_type(reader, node, key);
        case Kind::word:
        case Kind::source:
            return read_word(reader, node, key, value);
        case Kind::sensor:
        case Kind::switch_function:
        case Kind::measurement:
            return read_name(reader, node, key, value);
        case Kind::error:
        case Kind::error_or_any:
            return read_error(reader, node, key, value);
        case Kind::object:
            return read_object(reader, node, key, value);
        case Kind::steps:
            return node.kind == toml::Kind::array || wrong_type(reader, node, key);
    }
    return false;
}

}  // namespace cgw::scenario
