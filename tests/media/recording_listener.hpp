// Keeps what a channel tells.
#pragma once

#include <string>
#include <vector>

#include "media/channel.hpp"

namespace cgw::media::test {

class RecordingListener final : public ChannelListener {
  public:
    void frame(const frame::Frame& frame, Time) override { frames.push_back(frame); }
    void link_changed(LinkState state, std::string_view reason, Time) override {
        links.push_back((state == LinkState::up ? "up " : "down ") + std::string(reason));
    }
    void frames_lost(std::uint64_t count, Time) override { lost += count; }

    std::vector<frame::Frame> frames;
    std::vector<std::string> links;
    std::uint64_t lost = 0;
};

}  // namespace cgw::media::test
