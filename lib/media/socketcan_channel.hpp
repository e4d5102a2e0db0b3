// A CAN interface of the Linux kernel (SocketCAN) by its name: can0, vcan0. It begins unconnected; the first
// service() connects, and the listener hears link_changed(up).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "media/channel.hpp"
#include "media/descriptor.hpp"
#include "media/retry.hpp"

struct can_frame;

namespace cgw::media {

// Fails when the kernel has no CAN support, and when there is no such interface or it is no CAN interface. An
// interface that is down is no failure: it may come up later.
base::Result<std::unique_ptr<Channel>> open_socketcan(const std::string& name);

// One attempt to connect to an interface.
struct CanSocket {
    Descriptor descriptor;      // none: not now
    std::string reason;         // why not, without the interface's name
    bool out_of_place = false;  // nothing that waiting mends: no CAN support, no such interface
};

inline constexpr std::string_view no_such_interface = "there is no such interface";
inline constexpr std::string_view interface_down = "the interface is down";
inline constexpr std::string_view bus_off = "the controller is bus-off";

CanSocket open_can_socket(const std::string& name);

// Down are an interface that is down or removed and a controller that is bus-off; it is tried again until it
// is back. A controller that becomes error-passive, or recovers from that, is told as link_changed(up) with
// the reason: the link stays. Own frames are not received back; other programs on this machine see them.
class SocketCanChannel final : public Channel {
  public:
    using Open = std::function<CanSocket(const std::string& name)>;

    // `open` makes the socket, which carries whole can_frame records.
    SocketCanChannel(std::string name, Open open) : name_(std::move(name)), open_(std::move(open)) {}

    bool send(const frame::Frame& frame) override;
    int descriptor() const override { return socket_.get(); }
    short events() const override;
    void service(Time now, ChannelListener& listener) override;
    Time deadline() const override;
    std::optional<std::uint32_t> bit_rate() const override;

  private:
    enum class Received : std::uint8_t { frame, nothing, failed };

    void connect(ChannelListener& listener);
    void receive(ChannelListener& listener);
    Received receive_one(ChannelListener& listener);
    void take(const can_frame& raw, ChannelListener& listener);
    void take_error(const can_frame& raw, ChannelListener& listener);
    void tell(LinkState state, const std::string& reason, ChannelListener& listener);

    std::string name_;
    Open open_;
    Descriptor socket_;
    Retry retry_;
    Time now_ = 0;               // of the latest service()
    std::string fault_;          // why the socket is of no more use; empty: it is
    std::string told_;           // what was said last while the link is down
    std::uint32_t dropped_ = 0;  // the kernel's count, of this socket
    bool refused_ = false;       // the kernel's transmit queue was full since the latest service()
    bool error_passive_ = false;
};

}  // namespace cgw::media
