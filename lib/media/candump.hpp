// Frames as lines of `candump -L`: (seconds.microseconds) interface 123#1122. Eight identifier digits mean a
// 29-bit one, #R a remote frame. can-utils, Wireshark and python-can read it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "frame/frame.hpp"

namespace cgw::media {

struct LoggedFrame {
    std::uint64_t time_us = 0;
    std::string interface_name;
    frame::Frame frame;

    friend bool operator==(const LoggedFrame&, const LoggedFrame&) = default;
};

// Without a line feed.
std::string candump_line(const LoggedFrame& logged);

// Nothing when the line is not exactly of that form. A remote frame's length digit is optional.
std::optional<LoggedFrame> parse_candump_line(std::string_view line);

// Collects a whole log, to be written in one step.
class CandumpLog {
  public:
    explicit CandumpLog(std::string interface_name) : interface_name_(std::move(interface_name)) {}

    void record(const frame::Frame& frame, std::uint64_t time_us);

    std::size_t frames() const { return frames_; }
    const base::Bytes& content() const { return content_; }

  private:
    std::string interface_name_;
    std::size_t frames_ = 0;
    base::Bytes content_;
};

}  // namespace cgw::media
