#include "input/network_section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/canopen_text.hpp"
#include "diagnostic/rules/keys.hpp"
#include "facts/identifiers.hpp"

namespace cgw::input {
namespace {

namespace rules = diagnostic::rules;
using toml::Entry;
using toml::Kind;
using toml::Node;

constexpr Key node_id = {.name = "a node id",
                         .kind = Kind::integer,
                         .limit = Limit::value,
                         .minimum = 1,
                         .maximum = facts::maximum_node_id,
                         .text = "node id of another node"};

void read_nodes(Context& context, const Entry& entry) {
    std::map<std::int64_t, diagnostic::Range> listed;
    for (const Node& element : entry.value.elements) {
        if (!check_value(context, element, node_id, node_id.name)) {
            continue;
        }
        const auto [first, is_new] = listed.try_emplace(element.integer, element.range);
        if (is_new) {
            context.settings().network_nodes.push_back(
                {static_cast<std::uint8_t>(element.integer), context.at(element.range)});
            continue;
        }
        context.findings.report({&rules::network_node_duplicate,
                                 fmt::format("node {} is listed twice", element.integer),
                                 context.at(element.range),
                                 {{context.at(first->second), "first listed here"}}});
    }
}

// --- [[network.message]] ---

constexpr std::int64_t longest_period_ms = 3'600'000;

parameter::NetworkMessage& message_of(Context& context) {
    return context.settings().network_messages.back();
}

// cgw counts in whole microseconds: what is finer is not rounded away in silence.
std::uint64_t microseconds_of(Context& context, const Entry& entry) {
    const double exact = entry.value.real * 1000;
    const double whole = std::round(exact);
    constexpr double binary_noise = 1e-5;  // of 3.6e9 us as a double
    if (std::abs(exact - whole) > binary_noise) {
        context.report(
            rules::key_value, entry.value.range,
            fmt::format("`{}` is {}, finer than a microsecond (0.001)", entry.key, entry.value.text));
    }
    return static_cast<std::uint64_t>(whole);
}

// One that is above 0.
std::uint64_t time_of(Context& context, const Entry& entry) {
    if (entry.value.real == 0) {
        context.report(rules::key_value, entry.value.range,
                       fmt::format("`{}` is {}, which is no time", entry.key, entry.value.text));
    }
    return microseconds_of(context, entry);
}

void read_period(Context& context, const Entry& entry) {
    message_of(context).period_us = time_of(context, entry);
}

constexpr Key message_keys[] = {
    {"id", Kind::integer, Presence::required, Limit::value, 0, facts::cob::highest,
     [](Context& context, const Entry& entry) {
         message_of(context).identifier = static_cast<std::uint16_t>(entry.value.integer);
     },
     "its identifier (COB-ID), 11 bits"},
    {"bytes", Kind::integer, Presence::optional, Limit::value, 0, 8,
     [](Context& context, const Entry& entry) {
         message_of(context).bytes = static_cast<std::uint8_t>(entry.value.integer);
     },
     "its data bytes", "8"},
    {"period_ms", Kind::real, Presence::required, Limit::value, 0, longest_period_ms, read_period,
     "time between two of them in ms, the shortest one; above 0"},
    {"name", Kind::string, Presence::optional, Limit::bytes, 1, 60,
     [](Context& context, const Entry& entry) { message_of(context).name = entry.value.text; },
     "what it is called in reports"},
    {"jitter_ms", Kind::real, Presence::optional, Limit::value, 0, longest_period_ms,
     [](Context& context, const Entry& entry) {
         message_of(context).jitter_us = microseconds_of(context, entry);
     },
     "how late its sender may be with it, in ms", "0"},
    {"deadline_ms", Kind::real, Presence::optional, Limit::value, 0, longest_period_ms,
     [](Context& context, const Entry& entry) { message_of(context).deadline_us = time_of(context, entry); },
     "time in ms within which it must be through; without it, its period"},
};
constexpr Table message_table{"network.message", message_keys};
constexpr Key message_row = {.name = "a message", .kind = Kind::table, .below = &message_table};

// Rows with a finding take part in nothing.
void read_messages(Context& context, const Entry& entry) {
    std::vector<parameter::NetworkMessage>& messages = context.settings().network_messages;
    for (const Node& element : entry.value.elements) {
        if (!check_value(context, element, message_row, message_row.name)) {
            continue;
        }
        const std::size_t before = context.findings.all().size();
        messages.push_back({.where = context.at(element.range)});
        read_table(context, element, message_table);
        if (context.findings.all().size() != before) {
            messages.pop_back();
            continue;
        }
        parameter::NetworkMessage& message = messages.back();
        message.name =
            message.name.empty() ? "message " + base::identifier_text(message.identifier) : message.name;
        message.deadline_us = message.deadline_us == 0 ? message.period_us : message.deadline_us;
    }
}

constexpr Key network_keys[] = {
    {.name = "nodes",
     .kind = Kind::array,
     .read = read_nodes,
     .text = "node ids of the other nodes on the CANopen bus, against which identifiers are checked (D33)",
     .element = &node_id},
    {.name = "message",
     .kind = Kind::array,
     .read = read_messages,
     .text = "messages that other nodes send, for cgw network (D75)",
     .element = &message_row},
};

}  // namespace

constinit const Table network_table{"network", network_keys};

}  // namespace cgw::input
