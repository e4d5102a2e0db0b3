// An NMT slave with boot-up, heartbeat, SDO server and PDO engine: the part all our devices share. It is a
// state machine over frames and time; not reentrant, one caller at a time, hence no torn values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "canopen/arrival_monitor.hpp"
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
        ObjectHandler* handler = nullptr;  // of objects with a handler number; none: plain memory
        std::span<const PdoRow> transmit;
        std::span<TransmitState> transmit_states;  // one per transmit row
        std::span<const PdoRow> receive;
        std::span<ArrivalMonitor> receive_monitors;  // one per receive row
        std::uint8_t partner_node = 0;               // whose heartbeat is watched; 0: nobody's
        Time partner_period = 0;                     // 0: not watched
    };

    // What a frame meant to the device around the slave.
    struct Event {
        enum class Kind : std::uint8_t {
            none,
            state_changed,  // by an NMT command; state() is the new one
            reset,          // 81h or 82h: the slave is initialising until boot_up()
            pdo_received,   // `position`: row of Tables::receive
            heartbeat,      // of the watched partner
            sdo_overflow,   // more requests than answers can wait; this one is not answered
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
    // The device changes its state for a reason of its own; not to initialising.
    void force(NmtState state, Time now) { enter(state, now); }
    // A sign of life out of turn: see HeartbeatProducer::announce.
    void announce(Time now) { heartbeat_.announce(now); }
    void withdraw_announcement() { heartbeat_.withdraw_announcement(); }
    // Answers that still wait are not sent any more: who asked has given up long ago.
    void drop_answers() { sdo_.clear(); }
    // 1017h was written: the next heartbeat comes one new period from now; 0: none any more.
    void set_heartbeat_period(Time period, Time now) {
        const bool off = period == 0 || state_ == NmtState::initialising;
        heartbeat_.set_period(period, off ? never : now + period);
    }
    NmtState state() const { return state_; }

    // A request to transmit counts in Operational only.
    void request(std::size_t transmit_row) {
        if (state_ == NmtState::operational) {
            transmitter_.request(transmit_row);
        }
    }
    void request_if_changed(std::size_t transmit_row) {
        if (state_ == NmtState::operational) {
            transmitter_.request_if_changed(transmit_row);
        }
    }

    Event receive(const frame::Frame& frame, Time now);

    // Sends whatever is due and whatever the port did not take before. Returns when time alone will make
    // something due; while pending() is true, call again as soon as the port has room.
    Time poll(Time now);
    bool pending() const { return heartbeat_.pending() || sdo_.pending() || transmitter_.pending(); }

    const SdoServer& sdo() const { return sdo_; }
    const PdoTransmitter& transmitter() const { return transmitter_; }
    PdoTransmitter& transmitter() { return transmitter_; }  // for a PdoSchedule; in Operational only
    const PdoReceiver& receiver() const { return receiver_; }
    // Armed in Operational only, as are the receive monitors.
    const ArrivalMonitor& heartbeat_monitor() const { return heartbeat_monitor_; }

  private:
    Event receive_sdo(const frame::Frame& frame);
    Event receive_in_operational(const frame::Frame& frame, Time now);
    Event receive_heartbeat(const frame::Frame& frame, Time now);
    Event obey(const frame::Frame& frame, Time now);
    void enter(NmtState state, Time now);
    void watch(bool operational, Time now);
    Time expire_monitors(Time now);
    void send_due(Time now);

    frame::FramePort* port_;
    std::uint8_t node_id_ = 0;
    NmtState state_ = NmtState::initialising;
    HeartbeatProducer heartbeat_;
    SdoServer sdo_;
    PdoTransmitter transmitter_;
    PdoReceiver receiver_;
    std::span<ArrivalMonitor> receive_monitors_;
    std::uint8_t partner_node_ = 0;
    ArrivalMonitor heartbeat_monitor_;
    Time next_trip_ = 0;  // when a monitor may trip next; 0: to be worked out
};

}  // namespace cgw::canopen
