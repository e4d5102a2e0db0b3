// Frames as lines of `candump -L`: (seconds.microseconds) interface 123#1122. Eight identifier digits mean a
// 29-bit one, #R a remote frame. can-utils, Wireshark and python-can read it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "media/logged_frame.hpp"

namespace cgw::media {

// Without a line feed.
std::string candump_line(const LoggedFrame& logged);

// Microseconds, of the six or nine digits behind the point of a time.
std::optional<std::uint64_t> candump_fraction_us(std::string_view digits);

// Nothing when the line is not exactly of that form, or with nanoseconds. A remote frame's length digit is optional.
std::optional<LoggedFrame> parse_candump_line(std::string_view line);

enum class LineKind : std::uint8_t {
    frame,
    passed_over,  // an error frame or a CAN FD frame
    blank,
    wrong,
};

struct ReadLine {
    LineKind kind = LineKind::wrong;
    LoggedFrame logged{};  // of a frame
};

// One line of candump -L; carriage returns and blanks at the ends, and the direction R or T that newer
// recorders add, are fine.
ReadLine read_candump_line(std::string_view line);

// All lines of a log. Blank lines, carriage returns, and the direction R or T that newer recorders add are
// fine; error frames and CAN FD frames are passed over. Any other line is a failure: "run.log:3: …", where
// `name` is the file's.
base::Result<Log> read_candump(std::string_view text, const std::string& name);

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
