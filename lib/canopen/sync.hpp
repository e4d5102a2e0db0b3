// The SYNC object, both ends (CiA 301, 7.2.5): objects 1005h (identifier), 1006h (period), 1019h (counter).
#pragma once

#include <cstdint>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::canopen {

class SyncConsumer {
  public:
    struct Sync {
        enum class Kind : std::uint8_t {
            none,          // no SYNC
            sync,          // `counter` holds; 0 when SYNC carries none
            wrong_length,  // of the right identifier: not obeyed (CiA 301 suggests EMCY 8240h)
        };
        Kind kind = Kind::none;
        std::uint8_t counter = 0;
    };

    SyncConsumer() = default;
    // `counter_overflow` is 1019h: 0, or the highest counter (2..240), and SYNC has one byte then.
    explicit SyncConsumer(std::uint32_t cob_id, std::uint8_t counter_overflow = 0)
        : cob_id_(cob_id), counter_overflow_(counter_overflow) {}

    Sync receive(const frame::Frame& frame) const;

  private:
    std::uint32_t cob_id_ = cob::sync;
    std::uint8_t counter_overflow_ = 0;
};

class SyncProducer {
  public:
    SyncProducer() = default;
    // `period` in microseconds; 0: none.
    SyncProducer(std::uint32_t cob_id, Time period, std::uint8_t counter_overflow = 0)
        : cob_id_(cob_id), period_(period), counter_overflow_(counter_overflow) {}

    // The first SYNC is due now, with counter 1.
    void start(Time now);
    void stop() {
        deadline_ = never;
        refused_ = false;
    }

    // Sends what is due and returns when the next is. The rhythm is kept: a SYNC sent late does not shift the
    // following ones, missed ones are not made up and do not count.
    Time poll(Time now, frame::FramePort& port);
    // The port did not take a SYNC that was due: poll again as soon as it has room.
    bool pending() const { return refused_; }

  private:
    frame::Frame next_frame() const;

    std::uint32_t cob_id_ = cob::sync;
    Time period_ = 0;
    std::uint8_t counter_overflow_ = 0;
    std::uint8_t counter_ = 1;
    bool refused_ = false;
    Time deadline_ = never;
};

}  // namespace cgw::canopen
