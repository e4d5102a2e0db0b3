// A connection to a CAN bus from the text that people write for it: hub:127.0.0.1:29536/can1.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "media/channel.hpp"

namespace cgw::media {

struct ChannelKind {
    std::string_view name;     // what stands before the first colon
    std::string_view form;     // how the whole is written: "hub:HOST:PORT[/BUS]"
    std::string_view summary;  // for help, one line
    // `whole` is the text as written, `rest` what follows the first colon. What is wrong with the text;
    // empty: nothing, and then it can be opened.
    std::string (*mistake)(std::string_view whole, std::string_view rest);
    base::Result<std::unique_ptr<Channel>> (*open)(std::string_view whole, std::string_view rest);
    std::string (*bus)(std::string_view rest);  // for same_bus()
};

std::span<const ChannelKind> channel_kinds();

// What is wrong with `text` as a text, one line; empty: nothing.
std::string channel_mistake(std::string_view text);

// Whether two texts without a mistake mean one bus. Names of one host that differ are not seen through.
bool same_bus(std::string_view a, std::string_view b);

// The failure is a mistake in `text`, or a host, an interface or a serial port that does not exist. Whether
// the bus can be reached is heard from the channel, which keeps trying.
base::Result<std::unique_ptr<Channel>> open_channel(std::string_view text);

}  // namespace cgw::media
