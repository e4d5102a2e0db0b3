// The gateway's own time in a real-time run: microseconds since its start, never backwards.
#pragma once

#include "media/channel.hpp"

namespace cgw::runtime {

using media::Time;

// Time in which the program did not run (SIGSTOP, a debugger, a machine that stood still) is left out: it is
// no time in which a partner was silent, and a simulated bus does not live through it afterwards.
class RunClock {
  public:
    // A loop that runs is here more often than ten times a second.
    static constexpr Time longest_pause = 2'000'000;

    explicit RunClock(Time start) : start_(start), last_(start) {}

    // The gateway's time at `steady`.
    Time at(Time steady);
    // What the last at() has left out; 0 almost always.
    Time left_out() const { return left_out_; }
    // When it will be `time`; never stays never.
    Time steady_at(Time time) const { return time == media::never ? time : time + start_ + total_left_out_; }

  private:
    Time start_;
    Time last_;  // steady time of the last at()
    Time left_out_ = 0;
    Time total_left_out_ = 0;
};

}  // namespace cgw::runtime
