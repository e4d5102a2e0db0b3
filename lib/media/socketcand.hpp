// The protocol of socketcand (https://github.com/linux-can/socketcand, doc/protocol.md) as the hub and its
// clients speak it: messages between < and > on a stream of bytes, in ASCII.
//
//   hub      < hi >                        greets whoever connects
//   client   < open can0 >     hub < ok >  chooses the bus
//   client   < rawmode >       hub < ok >  wants every frame from now on
//   client   < send 123 2 1 f1 >           identifier, length, that many bytes, hexadecimal; 29-bit: 8 digits
//   client   < sendrtr 123 2 >             a remote frame
//   hub      < frame 123 23.424242 01F1 >  seconds.microseconds; 29-bit: 8 digits
//   hub      < rtr 123 23.424242 2 >
//   client   < echo >          hub the same
//   hub      < error text >
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "frame/frame.hpp"

namespace cgw::media {

// Cuts a stream into messages. They may straddle append() or come several at once.
class MessageStream {
  public:
    // Bytes of a message with < and >; three times what one with a frame needs.
    static constexpr std::size_t longest = 200;

    enum class Item : std::uint8_t {
        none,      // append more
        message,   // in `text`
        junk,      // between messages stands something else than blanks; said once for a run of it
        too_long,  // no > within `longest` bytes: the stream cannot be followed any further
    };

    void append(std::string_view bytes);

    // `text`: what stands between < and >, without blanks at both ends; valid until the next append().
    Item next(std::string_view& text);

    void clear();

  private:
    Item message(std::string_view& text);

    std::string buffer_;
    std::size_t at_ = 0;
    bool in_junk_ = false;
};

// The first word of `text`, cut off from it with the blanks behind it; empty at the end.
std::string_view next_word(std::string_view& text);

// A message of these words. Characters that would end it or steer a terminal become '?', a long text is cut.
std::string message_of(std::string_view words);
std::string error_message(std::string_view text);

// From a client. The text that follows `send` or `sendrtr` back to a frame; failures say what is wrong.
std::string send_message(const frame::Frame& frame);
base::Result<frame::Frame> parse_send(std::string_view words);
base::Result<frame::Frame> parse_sendrtr(std::string_view words);

// From the hub, `frame` or `rtr`. It begins with a line feed: python-can 4.1 drops the first byte of
// a message that it has received in part, when it follows another one.
std::string frame_message(const frame::Frame& frame, std::uint64_t time_us);
// The text that follows `frame` or `rtr` back to a frame; the bytes may stand apart.
std::optional<frame::Frame> parse_frame(std::string_view words);
std::optional<frame::Frame> parse_rtr(std::string_view words);

// From the hub to a client that was too slow: an error, which other clients show or ignore.
std::string lost_message(std::uint64_t frames);
// The text that follows `error` back to a number of frames.
std::optional<std::uint64_t> parse_lost(std::string_view words);

// What a bus may be called: 1 to 16 letters, digits, '.', '_', '-'.
bool is_bus_name(std::string_view name);

}  // namespace cgw::media
