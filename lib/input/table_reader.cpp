#include "input/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "base/edit_distance.hpp"
#include "base/utf8.hpp"
#include "diagnostic/rules/keys.hpp"
#include "input/parameter_keys.hpp"

namespace cgw::input {

namespace rules = diagnostic::rules;
using parameter::Device;
using toml::Entry;
using toml::Kind;
using toml::Node;

std::string did_you_mean(std::string_view text, std::span<const std::string_view> candidates) {
    const std::string near = base::nearest_name(text, candidates);
    return near.empty() ? "" : fmt::format("did you mean `{}`?", near);
}

bool check_type(Context& context, const Node& value, Kind kind, std::string_view what) {
    const bool is_whole_number = kind == Kind::real && value.kind == Kind::integer;
    if (value.kind == kind || is_whole_number) {
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
    std::string message;
    if (size < minimum) {
        message = fmt::format("{} is empty", what);
    } else if (size > maximum) {
        message = fmt::format("{} has {} bytes, more than {}", what, size, maximum);
    } else if (base::has_control(value.text)) {
        message = fmt::format("{} contains a control character", what);
    } else {
        return true;
    }
    context.report(rules::key_value, value.range, std::move(message));
    return false;
}

namespace {

bool check_real(Context& context, const Node& value, const Key& key, std::string_view what) {
    if (value.real >= static_cast<double>(key.minimum) && value.real <= static_cast<double>(key.maximum)) {
        return true;
    }
    context.report(rules::key_value, value.range,
                   fmt::format("{} is {}, outside {}..{}", what, value.text, key.minimum, key.maximum));
    return false;
}

bool check_limit(Context& context, const Node& value, const Key& key, std::string_view what) {
    switch (key.limit) {
        case Limit::none:
            return true;
        case Limit::value:
            return key.kind == Kind::real ? check_real(context, value, key, what)
                                          : check_integer(context, value, key.minimum, key.maximum, what);
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

std::vector<std::string_view> names_of(std::span<const Key> keys) {
    std::vector<std::string_view> names;
    std::transform(keys.begin(), keys.end(), std::back_inserter(names),
                   [](const Key& key) { return key.name; });
    return names;
}

const Key* find_key(std::span<const Key> keys, std::string_view name) {
    const auto key =
        std::find_if(keys.begin(), keys.end(), [&](const Key& candidate) { return candidate.name == name; });
    return key == keys.end() ? nullptr : &*key;
}

// [gatewayparameters] for [gateway.parameters]
const Key* lost_dot(const Entry& entry, const Table& table) {
    return entry.value.kind == Kind::table
               ? find_key(table.joined, base::nearest_name(entry.key, names_of(table.joined)))
               : nullptr;
}

bool has_parameters(const Node& node, const Table& table, Device device) {
    if (table.device) {
        return node.find("parameters") != nullptr;
    }
    const Entry* section = node.find(parameter::to_text(device));
    return section != nullptr && section->value.find("parameters") != nullptr;
}

// The device whose parameters were to stand below a header that is not there, when this is one of them.
std::optional<Device> misplaced_device(const Context& context, const Node& node, const Entry& entry,
                                       const Table& table) {
    if (entry.value.kind == Kind::table || !(table.device || table.name.empty())) {
        return std::nullopt;
    }
    for (const Device device : {Device::governor, Device::gateway}) {
        if ((!table.device || table.device == device) && !has_parameters(node, table, device) &&
            resolve_silently(context.catalogue, device, entry.key) != nullptr) {
            return device;
        }
    }
    return std::nullopt;
}

void report_unknown(Context& context, const Node& node, const Entry& entry, const Table& table) {
    const std::optional<Device> misplaced = misplaced_device(context, node, entry, table);
    if (misplaced && !context.is_first_misplaced(*misplaced)) {
        return;
    }
    std::string help = did_you_mean(entry.key, names_of(table.keys));
    if (const Key* joined = help.empty() ? lost_dot(entry, table) : nullptr) {
        help = fmt::format("did you mean [{}]?", joined->name);
    }
    if (table.device && resolve_silently(context.catalogue, *table.device, entry.key) != nullptr) {
        help = fmt::format("parameters of the {} stand in [{}.parameters]", table.name, table.name);
    }
    if (misplaced) {
        const std::string_view device = parameter::to_text(*misplaced);
        help = fmt::format("parameters of the {} stand in [{}.parameters], and the file has no such header",
                           device, device);
    }
    const bool is_table = entry.value.kind == Kind::table;
    context.report(
        rules::key_unknown, entry.key_range,
        fmt::format("unknown {} {} {}", is_table ? "table" : "key", toml::quoted(entry.key), place_of(table)),
        std::move(help));
}

// The table that one under an unknown name is read as; nullptr when it was meant to be none, or one that is
// there as well.
const Key* meant_table(const Node& node, const Entry& entry, const Table& table, std::string_view near) {
    if (entry.value.kind != Kind::table) {
        return nullptr;
    }
    if (near.empty()) {
        return lost_dot(entry, table);
    }
    const Key* key = find_key(table.keys, near);
    const bool is_free = key->presence == Presence::split || node.find(near) == nullptr;
    return key->kind == Kind::table && is_free ? key : nullptr;
}

}  // namespace

bool check_value(Context& context, const Node& value, const Key& key, std::string_view what) {
    return check_type(context, value, key.kind, what) && check_limit(context, value, key, what);
}

const Entry* misspelt(const Node& node, const Table& table, std::string_view name) {
    const std::vector<std::string_view> names = names_of(table.keys);
    const auto is_meant = [&](const Entry& entry) {
        return find_key(table.keys, entry.key) == nullptr && base::nearest_name(entry.key, names) == name;
    };
    const auto entry = std::find_if(node.entries.begin(), node.entries.end(), is_meant);
    return entry == node.entries.end() ? nullptr : &*entry;
}

void read_table(Context& context, const Node& node, const Table& table) {
    // One slip, one finding: the key that was probably meant is not missing, and a table is read as it.
    std::set<std::string, std::less<>> meant;
    for (const Entry& entry : node.entries) {
        const Key* key = find_key(table.keys, entry.key);
        if (key == nullptr) {
            report_unknown(context, node, entry, table);
            const std::string near = base::nearest_name(entry.key, names_of(table.keys));
            meant.insert(near);
            key = meant_table(node, entry, table, near);
            if (key == nullptr) {
                continue;
            }
        }
        const std::string what = toml::quoted(entry.key);
        if (!check_value(context, entry.value, *key, what)) {
            continue;
        }
        if (key->read != nullptr) {
            key->read(context, entry);
        } else if (key->below != nullptr) {
            read_table(context, entry.value, *key->below);
        }
    }
    for (const Key& key : table.keys) {
        if (key.presence == Presence::required && !meant.contains(key.name) &&
            node.find(key.name) == nullptr) {
            context.report(rules::key_missing, node.range,
                           fmt::format("`{}` is missing {}", key.name, place_of(table)));
        }
    }
}

}  // namespace cgw::input
