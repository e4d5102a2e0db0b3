// A small CANopen master: NMT commands, SYNC, what the nodes say of themselves, an SDO client, process data
// in both directions. No heap, never blocks; time is handed in.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canopen/emergency.hpp"
#include "canopen/protocol.hpp"
#include "canopen/sdo_client.hpp"
#include "canopen/sync.hpp"
#include "frame/frame.hpp"
#include "master/command_queue.hpp"
#include "master/node_table.hpp"

namespace cgw::master {

// What the master hears. Called from within Master::receive(), lost() from within Master::poll().
class Listener {
  public:
    virtual void boot_up(std::uint8_t node_id, canopen::Time now) = 0;
    virtual void heartbeat(std::uint8_t node_id, canopen::NmtState state, canopen::Time now) = 0;
    virtual void process_data(const frame::Frame& frame, canopen::Time now) = 0;  // a subscribed identifier
    virtual void emergency(const canopen::ReceivedEmergency& /*emergency*/, canopen::Time /*now*/) {}
    virtual void lost(std::uint8_t /*node_id*/, canopen::Time /*now*/) {}  // see NodeTable::watch

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
    // The same, sent by poll() as soon as the port takes it, in order; `all_nodes` starts the whole network
    // at once. False: too many wait.
    bool queue(canopen::NmtCommand command, std::uint8_t node_id) { return commands_.add(command, node_id); }
    bool send_process_data(std::uint16_t cob_id, std::span<const std::uint8_t> data);  // at most 8 bytes

    // False when `maximum_subscriptions` identifiers are taken.
    bool subscribe(std::uint16_t cob_id);

    // SYNC from now on, in the producer's rhythm; a producer without period ends it.
    void produce_sync(const canopen::SyncProducer& producer, canopen::Time now) {
        sync_ = producer;
        sync_.start(now);
    }

    // The nodes as boot-up messages and heartbeats show them, and who is watched.
    NodeTable& nodes() { return nodes_; }
    const NodeTable& nodes() const { return nodes_; }

    canopen::SdoClient& sdo() { return sdo_; }
    const canopen::SdoClient& sdo() const { return sdo_; }

    void receive(const frame::Frame& frame, canopen::Time now);
    // Sends what is due. Returns when time alone will make something due; while pending() is true, call again
    // as soon as the port has room.
    canopen::Time poll(canopen::Time now);
    bool pending() const { return sdo_.pending() || sync_.pending() || commands_.pending(); }

  private:
    void receive_heartbeat(const frame::Frame& frame, canopen::Time now);

    frame::FramePort* port_;
    Listener* listener_;
    canopen::SdoClient sdo_;
    canopen::SyncProducer sync_;
    CommandQueue commands_;
    NodeTable nodes_;
    std::array<std::uint16_t, maximum_subscriptions> subscriptions_{};
    std::size_t subscription_count_ = 0;
};

}  // namespace cgw::master
