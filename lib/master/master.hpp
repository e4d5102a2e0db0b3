// A minimal CANopen master: NMT commands, boot-up and heartbeat listening, an SDO client, process data in
// both directions. No heap, never blocks; time is handed in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canopen/protocol.hpp"
#include "canopen/sdo_client.hpp"
#include "frame/frame.hpp"

namespace cgw::master {

// What the master hears. Called from within Master::receive().
class Listener {
  public:
    virtual void boot_up(std::uint8_t node_id, canopen::Time now) = 0;
    virtual void heartbeat(std::uint8_t node_id, canopen::NmtState state, canopen::Time now) = 0;
    virtual void process_data(const frame::Frame& frame, canopen::Time now) = 0;  // a subscribed identifier

  protected:
    ~Listener() = default;
};

class Master {
  public:
    static constexpr std::size_t maximum_subscriptions = 64;

    // `sdo_timeout` in microseconds.
    Master(frame::FramePort& port, Listener& listener, std::uint8_t server_node_id, canopen::Time sdo_timeout)
        : port_(&port), listener_(&listener), sdo_(server_node_id, sdo_timeout) {}

    // False: the port says "not now"; nothing was sent and nothing is kept.
    bool command(canopen::NmtCommand command, std::uint8_t node_id);
    bool send_process_data(std::uint16_t cob_id, std::span<const std::uint8_t> data);  // at most 8 bytes

    // False when `maximum_subscriptions` identifiers are taken.
    bool subscribe(std::uint16_t cob_id);

    canopen::SdoClient& sdo() { return sdo_; }
    const canopen::SdoClient& sdo() const { return sdo_; }

    void receive(const frame::Frame& frame, canopen::Time now);
    canopen::Time poll(canopen::Time now) { return sdo_.poll(now, *port_); }
    bool pending() const { return sdo_.pending(); }

  private:
    void receive_heartbeat(const frame::Frame& frame, canopen::Time now);

    frame::FramePort* port_;
    Listener* listener_;
    canopen::SdoClient sdo_;
    std::array<std::uint16_t, maximum_subscriptions> subscriptions_{};
    std::size_t subscription_count_ = 0;
};

}  // namespace cgw::master
