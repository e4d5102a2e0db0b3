// A frame port that records what it takes and says "not now" once its room is used up.
#pragma once

#include <cstddef>
#include <vector>

#include "frame/frame.hpp"

namespace cgw::test {

inline frame::Frame make_frame(std::uint32_t id, const std::vector<std::uint8_t>& data) {
    frame::Frame frame;
    frame.id = id;
    frame.length = static_cast<std::uint8_t>(data.size());
    for (std::size_t i = 0; i < data.size(); ++i) {
        frame.data[i] = data[i];
    }
    return frame;
}

class RecordingPort final : public frame::FramePort {
  public:
    static constexpr std::size_t unlimited = ~std::size_t{0};

    bool send(const frame::Frame& frame) override {
        if (room == 0) {
            return false;
        }
        if (room != unlimited) {
            --room;
        }
        sent.push_back(frame);
        return true;
    }

    // The frames sent since the last call.
    std::vector<frame::Frame> take() {
        std::vector<frame::Frame> result;
        result.swap(sent);
        return result;
    }

    std::size_t room = unlimited;
    std::vector<frame::Frame> sent;
};

}  // namespace cgw::test
