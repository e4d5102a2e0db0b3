// Logs of CAN traffic, of whatever kind: candump -L text, or pcap.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/bytes.hpp"
#include "base/result.hpp"
#include "media/logged_frame.hpp"

namespace cgw::media {

enum class LogFormat : std::uint8_t { candump, pcap };

// For base::read_file(): some five million frames.
inline constexpr std::size_t largest_log = std::size_t{256} << 20;

// What a file of that name is to hold: .log is candump, .pcap and .cap are pcap; case does not matter.
std::optional<LogFormat> log_format_of(std::string_view file_name);

// Tells the formats apart by what they begin with. `name` begins the message of a failure.
base::Result<Log> read_log(std::string_view content, const std::string& name);

// Fails only on times that the format cannot hold.
base::Result<base::Bytes> write_log(LogFormat format, std::span<const LoggedFrame> frames);

}  // namespace cgw::media
