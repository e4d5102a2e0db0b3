// The emergency object (CiA 301, 7.2.7): EMCY frames, their producer, and the history 1003h. What the codes
// and the manufacturer's bytes mean is the device's (D67 for the governor).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"
#include "object/vocabulary.hpp"

namespace cgw::canopen {

struct Emergency {
    static constexpr std::uint16_t no_error = 0x0000;  // the code of "error reset"

    std::uint16_t code = no_error;
    std::uint8_t error_register = 0;  // 1001h at that moment
    std::array<std::uint8_t, 5> manufacturer{};

    friend bool operator==(const Emergency&, const Emergency&) = default;
};

frame::Frame emergency_frame(std::uint32_t cob_id, const Emergency& emergency);

struct ReceivedEmergency {
    std::uint8_t node_id = 0;
    Emergency emergency;
};
// Of the predefined identifiers 081h..0FFh. Nothing for another length than 8, a remote or extended frame.
std::optional<ReceivedEmergency> read_emergency(const frame::Frame& frame);

// Sends emergencies in the order in which they were reported, each once, no two within the inhibit time.
class EmergencyProducer {
  public:
    static constexpr std::size_t capacity = 8;  // that may wait

    struct Counters {
        std::uint32_t sent = 0;
        std::uint32_t dropped = 0;  // because `capacity` were waiting
    };

    EmergencyProducer() = default;
    // `inhibit` in microseconds (1015h counts 100 of them).
    EmergencyProducer(std::uint32_t cob_id, Time inhibit) : cob_id_(cob_id), inhibit_(inhibit) {}

    // False: too many wait; this one is dropped.
    bool report(const Emergency& emergency);
    void clear() { count_ = 0; }  // a reset: what waits is not sent any more

    // In Pre-Operational and Operational. Returns when time alone will let the next one go; while pending()
    // is true, call again as soon as the port has room.
    Time poll(Time now, frame::FramePort& port);
    bool pending() const { return refused_ && count_ != 0; }
    const Counters& counters() const { return counters_; }

  private:
    std::uint32_t cob_id_ = 0;
    Time inhibit_ = 0;
    Time free_at_ = 0;
    std::array<Emergency, capacity> waiting_{};  // ring
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    bool refused_ = false;
    Counters counters_;
};

// 1003h, the pre-defined error field: the newest error is sub 1, the oldest ones are forgotten.
class ErrorHistory {
  public:
    ErrorHistory() = default;
    // One entry per sub-index from 1 on, at most 254; they outlive the history.
    explicit ErrorHistory(std::span<std::uint32_t> entries) : entries_(entries) {}

    // `information` is the manufacturer's, the upper half of the entry.
    void add(std::uint16_t code, std::uint16_t information);
    std::size_t count() const { return count_; }

    // For an ObjectHandler. Sub 0 is the count and may be written with 0 only, which clears the history; a
    // sub-index beyond the count holds no data.
    object::AbortCode read(std::uint8_t sub_index, std::uint32_t& value) const;
    object::AbortCode write(std::uint8_t sub_index, std::uint32_t value);

  private:
    std::span<std::uint32_t> entries_;
    std::size_t count_ = 0;
};

}  // namespace cgw::canopen
