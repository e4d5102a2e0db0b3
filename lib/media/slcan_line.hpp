// slcan, the text protocol of serial CAN adapters: a frame is a line t123211A2, with T and eight identifier
// digits for 29 bits, r and R for remote frames; lines end with a carriage return, and a bell says no.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frame/frame.hpp"

namespace cgw::media {

// With the carriage return.
std::string slcan_line(const frame::Frame& frame);

// Without the carriage return. The four digits of a time stamp may follow.
std::optional<frame::Frame> parse_slcan_line(std::string_view line);

// The command that sets a bit rate in kbit/s, S0 to S8; nothing for a rate without one.
std::optional<std::string_view> slcan_bit_rate_command(unsigned kbit);

enum class SlcanAnswer : std::uint8_t {
    frame,     // a frame of the bus
    damaged,   // what was to be one
    accepted,  // the adapter does what it was told
    refused,   // it does not
};

struct SlcanEvent {
    SlcanAnswer answer = SlcanAnswer::accepted;
    frame::Frame frame;
};

// Makes lines of characters, however they come. Lines that say nothing are passed over.
class SlcanReader {
  public:
    std::optional<SlcanEvent> take(char character);
    void clear() { line_.clear(); }

  private:
    std::optional<SlcanEvent> read_line() const;

    std::string line_;
};

}  // namespace cgw::media
