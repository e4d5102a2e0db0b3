#include "media/open_channel.hpp"

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "media/hub_channel.hpp"
#include "media/slcan_channel.hpp"
#include "media/socketcan_channel.hpp"

namespace cgw::media {
namespace {

using Opened = base::Result<std::unique_ptr<Channel>>;

constexpr std::string_view hub_form = "hub:HOST:PORT[/BUS]";
constexpr std::string_view socketcan_form = "socketcan:INTERFACE";
constexpr std::string_view slcan_form = "slcan:TTY@KBIT";

std::string mistake(std::string_view whole, std::string_view what, std::string_view form) {
    return fmt::format("'{}': {}; write {}", whole, what, form);
}

std::string hub_mistake(std::string_view whole, std::string_view rest) {
    const std::size_t slash = rest.find('/');
    if (slash != std::string_view::npos && !is_bus_name(rest.substr(slash + 1))) {
        return mistake(whole, "a bus has a name of 1..16 letters, digits, '.', '_' or '-'", hub_form);
    }
    const auto where = parse_host_port(rest.substr(0, slash));
    if (!where) {
        return mistake(whole, where.error().message, hub_form);
    }
    return where->port != 0
               ? std::string()
               : mistake(whole, "port 0 is nobody's; cgw hub says on which port it listens", hub_form);
}

std::string hub_bus(std::string_view rest) {
    const bool is_named = rest.find('/') != std::string_view::npos;
    return is_named ? std::string(rest) : fmt::format("{}/{}", rest, HubChannelOptions().bus);
}

Opened open_hub(std::string_view whole, std::string_view rest) {
    HubChannelOptions options;
    const std::size_t slash = rest.find('/');
    if (slash != std::string_view::npos) {
        options.bus = rest.substr(slash + 1);
    }
    auto addresses = resolve(*parse_host_port(rest.substr(0, slash)));
    if (!addresses) {
        return base::failure(mistake(whole, addresses.error().message, hub_form));
    }
    return std::make_unique<HubChannel>(std::string(whole), std::move(*addresses), std::move(options));
}

std::string interface_mistake(std::string_view whole, std::string_view rest) {
    return rest.empty() ? mistake(whole, "no interface is named", socketcan_form) : "";
}

Opened open_interface(std::string_view /*whole*/, std::string_view rest) {
    return open_socketcan(std::string(rest));
}

std::string interface_bus(std::string_view rest) {
    return std::string(rest);
}

std::string adapter_mistake(std::string_view whole, std::string_view rest) {
    const std::size_t at = rest.rfind('@');
    const auto kbit = at == std::string_view::npos ? std::nullopt : base::parse_integer(rest.substr(at + 1));
    constexpr std::int64_t fastest = 1000;  // kbit/s; which of the lower ones exist open_slcan knows
    const bool fine = kbit && *kbit >= 1 && *kbit <= fastest && at != 0;
    return fine ? "" : mistake(whole, "a port and a bit rate are needed", slcan_form);
}

Opened open_adapter(std::string_view /*whole*/, std::string_view rest) {
    const std::size_t at = rest.rfind('@');
    return open_slcan(std::string(rest.substr(0, at)),
                      static_cast<unsigned>(*base::parse_integer(rest.substr(at + 1))));
}

// An adapter is one bus, whatever its rate.
std::string adapter_bus(std::string_view rest) {
    return std::string(rest.substr(0, rest.rfind('@')));
}

constexpr ChannelKind kinds[] = {
    {"hub", hub_form, "a bus of cgw hub or socketcand; BUS is can0 if not given", hub_mistake, open_hub,
     hub_bus},
    {"socketcan", socketcan_form, "a CAN interface of the Linux kernel, can0 or vcan0", interface_mistake,
     open_interface, interface_bus},
    {"slcan", slcan_form, "a serial adapter that speaks slcan, at KBIT kbit/s", adapter_mistake, open_adapter,
     adapter_bus},
};

std::string all_forms() {
    std::string forms;
    for (const ChannelKind& kind : kinds) {
        forms += fmt::format("{}{}", forms.empty() ? "" : " or ", kind.form);
    }
    return forms;
}

// The row for `text`, and what stands behind its colon; nullptr: none.
const ChannelKind* find_kind(std::string_view text, std::string_view& rest) {
    const std::size_t colon = text.find(':');
    for (const ChannelKind& kind : kinds) {
        if (colon != std::string_view::npos && text.substr(0, colon) == kind.name) {
            rest = text.substr(colon + 1);
            return &kind;
        }
    }
    return nullptr;
}

}  // namespace

std::span<const ChannelKind> channel_kinds() {
    return kinds;
}

std::string channel_mistake(std::string_view text) {
    std::string_view rest;
    const ChannelKind* const kind = find_kind(text, rest);
    return kind == nullptr ? fmt::format("'{}' is no CAN bus; write {}", text, all_forms())
                           : kind->mistake(text, rest);
}

bool same_bus(std::string_view a, std::string_view b) {
    std::string_view rest_a;
    std::string_view rest_b;
    const ChannelKind* const kind = find_kind(a, rest_a);
    return kind != nullptr && kind == find_kind(b, rest_b) && kind->bus(rest_a) == kind->bus(rest_b);
}

Opened open_channel(std::string_view text) {
    if (std::string what = channel_mistake(text); !what.empty()) {
        return base::failure(std::move(what));
    }
    std::string_view rest;
    return find_kind(text, rest)->open(text, rest);
}

}  // namespace cgw::media
