// Frames with their times, as logs hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame.hpp"

namespace cgw::media {

struct LoggedFrame {
    std::uint64_t time_us = 0;
    std::string interface_name;
    frame::Frame frame;

    friend bool operator==(const LoggedFrame&, const LoggedFrame&) = default;
};

struct Log {
    std::vector<LoggedFrame> frames;
    std::size_t passed_over = 0;  // records that are no classic frames: error frames, CAN FD
};

}  // namespace cgw::media
