// When transmit PDOs are due, by their transmission types (CiA 301, 18xxh sub 2, 3, 5, 6), for devices that
// have more than a rhythm of their own. In Operational, and in this order:
//   schedule.request_due(now, slave.transmitter());
//   slave.poll(now);
//   next = schedule.note_sent(now, slave.transmitter());
#pragma once

#include <cstdint>
#include <span>

#include "canopen/pdo.hpp"
#include "canopen/protocol.hpp"

namespace cgw::canopen {

// Transmission types; those between are synchronous, every n-th SYNC, or reserved.
namespace transmission {
inline constexpr std::uint8_t synchronous_acyclic = 0;   // at the SYNC that follows an event
inline constexpr std::uint8_t highest_cyclic = 240;      // 1..240: at every n-th SYNC
inline constexpr std::uint8_t remote_synchronous = 252;  // sampled at SYNC, sent on request
inline constexpr std::uint8_t remote = 253;              // sent on request
inline constexpr std::uint8_t event_manufacturer = 254;
inline constexpr std::uint8_t event_profile = 255;
}  // namespace transmission

struct PdoTiming {
    std::uint8_t type = transmission::event_manufacturer;
    std::uint8_t sync_start = 0;  // sub 6: the counter of the first SYNC that counts; 0: any
    bool remote_allowed = false;  // bit 30 of the COB-ID is 0
    Time inhibit = 0;             // microseconds, sub 3 in steps of 100; between frames of types 254 and 255
    Time event_period = 0;        // microseconds, sub 5 in steps of 1000; 0: none
};

struct PdoScheduleState {
    bool event = false;      // the device wants it sent
    bool due = false;        // a SYNC or a remote request makes it due
    bool requested = false;  // of the transmitter, and not yet known to have left
    bool counting = false;   // `sync_start` has been seen
    bool sampled = false;    // `sample` holds
    bool sample_due = false;
    std::uint8_t syncs = 0;
    Time free_at = 0;  // end of the inhibit time
    Time timer = never;
    PdoData sample{};
};

class PdoSchedule {
  public:
    PdoSchedule() = default;
    // One timing and one state per row; everything outlives the schedule.
    PdoSchedule(std::span<const PdoRow> rows, std::span<const PdoTiming> timings,
                std::span<PdoScheduleState> states, std::span<const std::uint8_t> values)
        : rows_(rows), timings_(timings), states_(states), values_(values) {}

    // Operational begins: event-driven PDOs are due once, timers run.
    void start(Time now);
    // Operational ends: nothing is due any more.
    void stop();

    // Something changed that the PDO tells of.
    void event(std::size_t position) { states_[position].event = true; }
    // A SYNC; `counter` is 0 when it carries none.
    void sync(std::uint8_t counter);
    // A remote frame. False: it asks for no PDO of ours, or for one that may not be asked for.
    bool remote_request(const frame::Frame& frame);

    void request_due(Time now, PdoTransmitter& transmitter);
    // What has left since. Returns when time alone will make a PDO due.
    Time note_sent(Time now, const PdoTransmitter& transmitter);

    // PDOs of type 252 that were asked for, with what the last SYNC found. False: the port did not take all.
    bool send_samples(frame::FramePort& port);

  private:
    void sync_cyclic(std::size_t position, std::uint8_t counter);

    std::span<const PdoRow> rows_;
    std::span<const PdoTiming> timings_;
    std::span<PdoScheduleState> states_;
    std::span<const std::uint8_t> values_;
};

}  // namespace cgw::canopen
