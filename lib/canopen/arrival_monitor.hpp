// Watches that something keeps arriving: a receive PDO, a partner's heartbeat. It trips when the time between
// two arrivals exceeds the period, and recovers with two arrivals that keep it (D44).
#pragma once

#include "canopen/protocol.hpp"

namespace cgw::canopen {

class ArrivalMonitor {
  public:
    ArrivalMonitor() = default;
    // `period` in microseconds; 0: never trips.
    explicit ArrivalMonitor(Time period) : period_(period) {}

    // Watching begins, untripped: the first arrival has one whole period (D54).
    void arm(Time now);
    // Nothing is watched, nothing is tripped.
    void disarm();

    void arrived(Time now);
    // Time passes.
    void expire(Time now) {
        if (active() && !tripped_ && now - last_ > period_) {
            tripped_ = true;
            arrived_since_trip_ = false;
        }
    }

    bool active() const { return armed_ && period_ != 0; }
    bool tripped() const { return tripped_; }
    // When expire() will trip; never when it cannot or has.
    Time deadline() const { return active() && !tripped_ ? last_ + period_ + 1 : never; }

  private:
    Time period_ = 0;
    Time last_ = 0;  // arrival, or the moment of arming
    bool armed_ = false;
    bool tripped_ = false;
    bool arrived_since_trip_ = false;
};

}  // namespace cgw::canopen
