// A log held against the plant: what is missing, what does not belong there, what comes at the wrong time or
// in the wrong length (D76). One pass, and memory that does not grow with the log.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "diagnostic/diagnostic.hpp"
#include "frame/frame.hpp"
#include "traffic/rhythm.hpp"
#include "traffic/service.hpp"

namespace cgw::traffic {

// One frame of the log.
struct Seen {
    std::uint64_t number = 0;  // line or record
    std::uint64_t time_us = 0;
    bool has_time = true;
    const frame::Frame& frame;
};

// Frames of a wrong length.
struct WrongLengths {
    std::uint64_t count = 0;
    Place first{};
    std::uint8_t bytes = 0;  // of the first one

    void add(std::uint8_t length, const Place& place);
};

// What was counted of one frame of the plant, or of a heartbeat.
struct Watched {
    std::string name;  // "TPDO4", "heartbeat of node 12"
    std::uint16_t identifier = 0;
    const signals::Frame* frame = nullptr;  // nullptr: a heartbeat
    Rhythm rhythm{};
    WrongLengths wrong{};   // the gateway drops or never sends them
    WrongLengths longer{};  // of an RPDO, of which the first bytes count (D28)
    std::uint64_t when_stopped = 0;
    Place first_when_stopped{};
};

class Audit {
  public:
    // Records that are no frames, and identifiers that nobody expects, beyond these are only counted.
    static constexpr std::size_t most_told = 10;

    // Both outlive it.
    Audit(const Subject& subject, const Owners& owners);

    void take(const Seen& seen);
    void take_fault(std::uint64_t number, const std::string& fault);
    void pass_over() { ++passed_over_; }
    // The log is over. `has_lines`: numbers are those of lines, not of records.
    void finish(bool has_lines);

    // After finish(), sorted by place. `path` is the log's.
    diagnostic::Findings findings(const std::string& path) const;

    const std::vector<Watched>& watched() const {
        return watched_;
    }  // frames as the subject has them, heartbeats
    std::uint64_t frames() const { return frames_; }
    std::uint64_t passed_over() const { return passed_over_; }  // error frames, CAN FD frames
    std::uint64_t faults() const { return faults_; }            // records that are no frames
    std::uint64_t of(Service service) const { return by_service_[static_cast<std::size_t>(service)]; }
    Microseconds first_us() const { return first_us_; }
    Microseconds last_us() const { return last_us_; }
    bool timed() const { return timed_; }  // every frame has a time
    bool was_operational() const { return was_operational_; }

  private:
    enum class State : std::uint8_t { unknown, operational, other };

    struct Fault {
        std::uint64_t number = 0;
        std::string text;
    };

    class Report;
    friend class Report;

    bool keep_time(const Seen& seen, Place& place);
    void watch(const Owner& owner, const frame::Frame& frame, const Place& place);
    void watch_command(const frame::Frame& frame, const Place& place);
    void watch_heartbeat(const Owner& owner, const frame::Frame& frame, const Place& place);
    void watch_pdo(const Owner& owner, const frame::Frame& frame, const Place& place);
    void watch_length(Watched& watched, const frame::Frame& frame, const Place& place);
    void enter_operational(const Place& place, bool recorded);
    void leave_operational(const Place& place, State state);
    void note_window(const Place& place);

    const Subject& subject_;
    const Owners& owners_;
    std::vector<Watched> watched_;
    std::array<std::uint8_t, 2048> watched_by_{};  // by identifier: place in watched_ + 1, 0: none
    std::array<std::uint64_t, 2048> unexpected_{};
    std::array<std::uint64_t, 2048> unexpected_at_{};
    std::array<std::uint64_t, 16> by_service_{};
    std::uint64_t extended_ = 0;
    std::uint64_t first_extended_ = 0;
    std::uint64_t frames_ = 0;
    std::uint64_t passed_over_ = 0;
    std::uint64_t faults_ = 0;
    std::vector<Fault> told_faults_;
    std::uint64_t backwards_ = 0;
    Place first_backwards_{};
    bool timed_ = true;
    bool began_ = false;
    bool has_lines_ = true;
    Microseconds first_us_ = 0;
    Microseconds last_us_ = 0;

    State state_ = State::unknown;
    Place state_since_{};
    bool was_operational_ = false;
    bool entry_recorded_ = false;         // the log has the command, or another state before
    Microseconds longest_window_us_ = 0;  // in Operational
};

}  // namespace cgw::traffic
