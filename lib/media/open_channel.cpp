#include "media/open_channel.hpp"

#include <fmt/format.h>

#include "media/hub_channel.hpp"

namespace cgw::media {
namespace {

using Opened = base::Result<std::unique_ptr<Channel>>;

Opened open_hub(std::string_view whole, std::string_view rest) {
    HubChannelOptions options;
    const std::size_t slash = rest.find('/');
    if (slash != std::string_view::npos) {
        options.bus = rest.substr(slash + 1);
        if (!is_bus_name(options.bus)) {
            return base::failure("a bus has a name of 1..16 letters, digits, '.', '_' or '-'");
        }
    }
    const auto where = parse_host_port(rest.substr(0, slash));
    if (!where) {
        return tl::unexpected(where.error());
    }
    if (where->port == 0) {
        return base::failure("port 0 is nobody's; cgw hub says on which port it listens");
    }
    auto addresses = resolve(*where);
    if (!addresses) {
        return tl::unexpected(addresses.error());
    }
    return std::make_unique<HubChannel>(std::string(whole), std::move(*addresses), std::move(options));
}

constexpr ChannelKind kinds[] = {
    {"hub", "hub:HOST:PORT[/BUS]", "a bus of cgw hub or socketcand; BUS is can0 if not given", open_hub},
};

std::string all_forms() {
    std::string forms;
    for (const ChannelKind& kind : kinds) {
        forms += fmt::format("{}{}", forms.empty() ? "" : " or ", kind.form);
    }
    return forms;
}

}  // namespace

std::span<const ChannelKind> channel_kinds() {
    return kinds;
}

Opened open_channel(std::string_view text) {
    const std::size_t colon = text.find(':');
    for (const ChannelKind& kind : kinds) {
        if (colon != std::string_view::npos && text.substr(0, colon) == kind.name) {
            Opened channel = kind.open(text, text.substr(colon + 1));
            return channel ? std::move(channel)
                           : base::failure(
                                 fmt::format("'{}': {}; write {}", text, channel.error().message, kind.form));
        }
    }
    return base::failure(fmt::format("'{}' is no CAN bus; write {}", text, all_forms()));
}

}  // namespace cgw::media
