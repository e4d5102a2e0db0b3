// An NMT slave with boot-up, heartbeat, SDO server and PDO engine: the part all our devices share. It is a
// state machine over frames and time; not reentrant, one caller at a time, hence no torn values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canopen/heartbeat.hpp"
#include "canopen/pdo.hpp"
#include "canopen/protocol.hpp"
#include "canopen/sdo_server.hpp"
#include "frame/frame.hpp"
#include "object/object_table.hpp"

namespace cgw::canopen {

class Slave {
  public:
    // Everything named here outlives the slave.
    struct Tables {
        std::uint8_t node_id = 0;
        Time heartbeat_period = 0;  // 0: off
        object::ObjectTable objects;
        std::span<std::uint8_t> values;
        std::span<const PdoRow> transmit;
        std::span<TransmitState> transmit_states;  // one per transmit row
        std::span<const PdoRow> receive;
    };

    // What a frame meant to the device around the slave.
    struct Event {
        enum class Kind : std::uint8_t {
            none,
            state_changed,  // by an NMT command; state() is the new one
            reset,          // 81h or 82h: the slave is initialising until boot_up()
            pdo_received,   // `position`: row of Tables::receive
        };
        Kind kind = Kind::none;
        std::size_t position = 0;
    };

    explicit Slave(frame::FramePort& port) : port_(&port) {}

    // Takes new tables; the slave is initialising afterwards.
    void configure(const Tables& tables);

    // Silent and deaf until boot_up(); whatever waited to be sent is dropped.
    void initialise();
    // Pre-Operational, and one boot-up message before anything else.
    void boot_up();
    NmtState state() const { return state_; }

    // A request to transmit counts in Operational only.
    void request(std::size_t transmit_row);
    void request_if_changed(std::size_t transmit_row);

    Event receive(const frame::Frame& frame);

    // Sends whatever is due and whatever the port did not take before. Returns when time alone will make
    // something due; while pending() is true, call again as soon as the port has room.
    Time poll(Time now);
    bool pending() const;

    const SdoServer& sdo() const { return sdo_; }
    const PdoTransmitter& transmitter() const { return transmitter_; }
    const PdoReceiver& receiver() const { return receiver_; }

  private:
    Event obey(NmtCommand command);
    void enter(NmtState state);
    void send_due(Time now);

    frame::FramePort* port_;
    std::uint8_t node_id_ = 0;
    NmtState state_ = NmtState::initialising;
    HeartbeatProducer heartbeat_;
    SdoServer sdo_;
    PdoTransmitter transmitter_;
    PdoReceiver receiver_;
};

}  // namespace cgw::canopen
