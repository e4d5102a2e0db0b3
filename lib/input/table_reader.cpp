#include "input/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "base/edit_distance.hpp"
#include "input/parameter_keys.hpp"

namespace cgw::input {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Kind;
using toml::Node;

std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates) {
    const std::string near = base::nearest_name(text, candidates);
    return near.empty() ? "" : fmt::format("did you mean `{}`?", near);
}

bool check_type(Context& context, const Node& value, Kind kind, std::string_view what) {
    if (value.kind == kind) {
        return true;
    }
    context.report(
        rules::key_type, value.range,
        fmt::format("{} must be {}, not {}", what, toml::to_text(kind), toml::to_text(value.kind)));
    return false;
}

bool check_integer(Context& context, const Node& value, std::int64_t minimum, std::int64_t maximum,
                   std::string_view what) {
    if (value.integer >= minimum && value.integer <= maximum) {
        return true;
    }
    context.report(rules::key_value, value.range,
                   fmt::format("{} is {}, outside {}..{}", what, value.text, minimum, maximum));
    return false;
}

bool check_text(Context& context, const Node& value, std::int64_t minimum, std::int64_t maximum,
                std::string_view what) {
    const auto size = static_cast<std::int64_t>(value.text.size());
    const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; };
    std::string message;
    if (size < minimum) {
        message = fmt::format("{} is empty", what);
    } else if (size > maximum) {
        message = fmt::format("{} has {} bytes, more than {}", what, size, maximum);
    } else if (std::any_of(value.text.begin(), value.text.end(), is_control)) {
        message = fmt::format("{} contains a control character", what);
    } else {
        return true;
    }
    context.report(rules::key_value, value.range, std::move(message));
    return false;
}

namespace {

bool check_limit(Context& context, const Node& value, const Key& key, std::string_view what) {
    switch (key.limit) {
        case Limit::none:
            return true;
        case Limit::value:
            return check_integer(context, value, key.minimum, key.maximum, what);
        case Limit::bytes:
            return check_text(context, value, key.minimum, key.maximum, what);
        case Limit::elements:
            break;
    }
    const auto maximum = static_cast<std::size_t>(key.maximum);
    if (value.elements.size() <= maximum) {
        return true;
    }
    context.report(rules::key_value, value.elements[maximum].range,
                   fmt::format("{} has {} elements, more than {}", what, value.elements.size(), maximum));
    return false;
}

std::string place_of(const Table& table) {
    return table.name.empty() ? "at the top of the file" : fmt::format("in [{}]", table.name);
}

std::vector<std::string_view> names_of(const Table& table) {
    std::vector<std::string_view> names;
    std::transform(table.keys.begin(), table.keys.end(), std::back_inserter(names),
                   [](const Key& key) { return key.name; });
    return names;
}

void report_unknown(Context& context, const Entry& entry, const Table& table) {
    std::string help = did_you_mean(entry.key, names_of(table));
    if (table.device && resolve_silently(context.catalogue, *table.device, entry.key) != nullptr) {
        help = fmt::format("parameters of the {} stand in [{}.parameters]", table.name, table.name);
    }
    const bool is_table = entry.value.kind == Kind::table;
    context.report(
        rules::key_unknown, entry.key_range,
        fmt::format("unknown {} {} {}", is_table ? "table" : "key", toml::quoted(entry.key), place_of(table)),
        std::move(help));
}

}  // namespace

void read_table(Context& context, const Node& node, const Table& table) {
    // One slip, one finding: the key that was probably meant is not missing, and a table is read as it.
    std::set<std::string, std::less<>> misspelt;
    for (const Entry& entry : node.entries) {
        auto key = std::find_if(table.keys.begin(), table.keys.end(),
                                [&](const Key& candidate) { return candidate.name == entry.key; });
        if (key == table.keys.end()) {
            report_unknown(context, entry, table);
            const std::string meant = base::nearest_name(entry.key, names_of(table));
            misspelt.insert(meant);
            key = std::find_if(table.keys.begin(), table.keys.end(), [&](const Key& candidate) {
                return candidate.name == meant && candidate.kind == Kind::table &&
                       entry.value.kind == Kind::table &&
                       (candidate.presence == Presence::split || node.find(meant) == nullptr);
            });
            if (key == table.keys.end()) {
                continue;
            }
        }
        const std::string what = toml::quoted(entry.key);
        if (check_type(context, entry.value, key->kind, what) &&
            check_limit(context, entry.value, *key, what)) {
            key->read(context, entry);
        }
    }
    for (const Key& key : table.keys) {
        if (key.presence == Presence::required && !misspelt.contains(key.name) &&
            node.find(key.name) == nullptr) {
            context.report(rules::key_missing, node.range,
                           fmt::format("`{}` is missing {}", key.name, place_of(table)));
        }
    }
}

}  // namespace cgw::input
