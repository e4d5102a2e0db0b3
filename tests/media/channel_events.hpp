// What a channel tells its listener, as lines of text.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "media/candump.hpp"
#include "media/channel.hpp"

namespace cgw::test {

// "123#1122": the part of a candump line behind the interface.
inline std::string frame_text(const frame::Frame& frame) {
    const std::string line = media::candump_line({0, "-", frame});
    return line.substr(line.rfind(' ') + 1);
}

class ChannelEvents final : public media::ChannelListener {
  public:
    void frame(const frame::Frame& frame, media::Time /*now*/) override {
        events.push_back("frame " + frame_text(frame));
    }
    void link_changed(media::LinkState state, std::string_view reason, media::Time /*now*/) override {
        events.push_back(fmt::format("{} {}", state == media::LinkState::up ? "up" : "down", reason));
    }
    void frames_lost(std::uint64_t count, media::Time /*now*/) override {
        events.push_back(fmt::format("lost {}", count));
    }

    // The events since the last call.
    std::vector<std::string> take() {
        std::vector<std::string> result;
        result.swap(events);
        return result;
    }

    std::vector<std::string> events;
};

using Events = std::vector<std::string>;

}  // namespace cgw::test
