// A connection to one CAN bus outside this program: an interface of the kernel, a hub, a serial adapter. It
// never blocks; whoever owns it waits with poll(2) for what it asks for, and calls service().
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "frame/frame.hpp"

namespace cgw::media {

// Microseconds of a steady clock.
using Time = std::uint64_t;
inline constexpr Time never = ~Time{0};

enum class LinkState : std::uint8_t { up, down };

class ChannelListener {
  public:
    virtual void frame(const frame::Frame& frame, Time now) = 0;
    // The connection is gone, or is back; `reason` is one line for people: "can0: the interface is down".
    virtual void link_changed(LinkState state, std::string_view reason, Time now) = 0;
    // Frames that came and were lost before anybody could take them.
    virtual void frames_lost(std::uint64_t count, Time now) = 0;

  protected:
    ~ChannelListener() = default;
};

class Channel : public frame::FramePort {
  public:
    virtual ~Channel() = default;
    Channel() = default;
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    // What poll(2) waits on, -1 while there is nothing; and for which events.
    virtual int descriptor() const = 0;
    virtual short events() const = 0;

    // Takes what came, sends what waits, tries to come back when the connection is gone.
    virtual void service(Time now, ChannelListener& listener) = 0;
    // When service() is wanted although nothing came.
    virtual Time deadline() const = 0;

    // Bits per second, where the connection knows at which rate the bus runs; nothing for a virtual bus.
    virtual std::optional<std::uint32_t> bit_rate() const { return std::nullopt; }
};

}  // namespace cgw::media
