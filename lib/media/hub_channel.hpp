// A bus of a hub as a Channel: cgw's own hub, or socketcand in front of a real interface.
#pragma once

#include <string>
#include <vector>

#include "media/channel.hpp"
#include "media/retry.hpp"
#include "media/send_queue.hpp"
#include "media/socketcand.hpp"
#include "media/tcp.hpp"

namespace cgw::media {

// Times in microseconds.
struct HubChannelOptions {
    std::string bus = "can0";
    Time handshake = 3'000'000;  // to connect, and to be let on the bus
    Time silence = 2'000'000;    // after that the hub is asked for an echo, and must answer in the same time
    std::size_t queued_bytes = 4096;  // of frames that the socket does not take, about 90; then "not now"
};

class HubChannel final : public Channel {
  public:
    // Tries `addresses` in their order; there is at least one. `name` begins every reason:
    // "hub:127.0.0.1:29536".
    HubChannel(std::string name, std::vector<Address> addresses, HubChannelOptions options);

    // False while the link is down, and when the hub does not take frames fast enough. Frames that were taken
    // but had not left when the link broke are gone, like those in a controller that is switched off.
    bool send(const frame::Frame& frame) override;

    int descriptor() const override { return socket_.get(); }
    short events() const override;
    void service(Time now, ChannelListener& listener) override;
    Time deadline() const override;

  private:
    // Down to up, in this order.
    enum class Phase : std::uint8_t { waiting, connecting, greeting, opening, entering, up };

    void connect(Time now, ChannelListener& listener);
    void finish_connect(Time now, ChannelListener& listener);
    void receive(Time now, ChannelListener& listener);
    void obey(std::string_view text, Time now, ChannelListener& listener);
    void proceed(std::string_view text, Time now, ChannelListener& listener);
    void take(std::string_view text, Time now, ChannelListener& listener);
    void rise(Time now, ChannelListener& listener);
    void check(Time now, ChannelListener& listener);
    void lose(std::string_view why, Time now, ChannelListener& listener);
    void flush();

    std::string name_;
    std::vector<Address> addresses_;
    HubChannelOptions options_;

    Phase phase_ = Phase::waiting;
    std::size_t address_ = 0;
    Descriptor socket_;
    MessageStream input_;
    SendQueue queue_;
    int send_error_ = 0;
    Retry retry_;
    Time handshake_until_ = 0;
    Time heard_ = 0;    // when the hub last said something
    Time asked_ = 0;    // when it was asked for an echo since; 0: not yet
    std::string told_;  // the last reason that the listener was given
};

}  // namespace cgw::media
