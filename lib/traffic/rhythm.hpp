// When the frames of one identifier came, held against the time that is set for them (D76).
#pragma once

#include <cstdint>

namespace cgw::traffic {

using Microseconds = std::uint64_t;

inline constexpr Microseconds start_grace_us = 100'000;  // after a start, for the first frame
inline constexpr double longest_gap_periods = 1.5;
inline constexpr double largest_deviation = 0.05;  // of the mean period
inline constexpr std::uint64_t fewest_gaps = 5;    // below which a mean says nothing

// Where a frame stands in the log.
struct Place {
    std::uint64_t number = 0;  // line or record, 0: none
    Microseconds time_us = 0;
};

// The longest of the gaps that were too long, and how many there were.
struct Gaps {
    std::uint64_t count = 0;
    Microseconds longest_us = 0;
    Place behind{};  // the frame that came late, or the end of the watch

    void add(Microseconds gap_us, const Place& place);
};

class Rhythm {
  public:
    // One of both, or neither: time between two frames as sent, longest time between two as received.
    Rhythm() = default;
    Rhythm(Microseconds period_us, Microseconds monitoring_us)
        : period_us_(period_us), monitoring_us_(monitoring_us) {}

    // A frame.
    void take(const Place& place);
    // A frame that its receiver drops: it is counted, and the receiver goes on waiting.
    void take_dropped() { ++frames_; }
    // Gaps count from here on, the first up to the grace longer; takes no frame.
    void arm(const Place& place);
    // They count no more. What is missing since the last frame is judged.
    void disarm(const Place& place);
    // The clock of the log is not to be trusted over this moment: the last frame is forgotten.
    void forget() { running_ = false; }

    std::uint64_t frames() const { return frames_; }
    std::uint64_t gaps() const { return gaps_; }
    Microseconds shortest_us() const { return shortest_us_; }
    Microseconds longest_us() const { return longest_us_; }
    double mean_us() const { return gaps_ == 0 ? 0 : sum_us_ / static_cast<double>(gaps_); }
    Microseconds period_us() const { return period_us_; }
    Microseconds monitoring_us() const { return monitoring_us_; }

    // Gaps over 1.5 periods; none where most are, since then the period is another one.
    Gaps late() const;
    // The mean that deviation() judges.
    double judged_mean_us() const;
    // How far the mean is from the period, as a part of it; 0 within what is tolerated. Gaps that are late()
    // do not count.
    double deviation() const;
    const Gaps& exceeded() const { return exceeded_; }  // of the monitoring time

  private:
    bool judge(Microseconds gap_us, const Place& place);  // true: over 1.5 periods
    bool other_period() const { return late_gaps_ * 2 > gaps_; }

    Microseconds period_us_ = 0;
    Microseconds monitoring_us_ = 0;
    bool running_ = false;
    bool first_ = false;  // since arm()
    Microseconds last_us_ = 0;
    std::uint64_t frames_ = 0;
    std::uint64_t gaps_ = 0;
    double sum_us_ = 0;
    std::uint64_t late_gaps_ = 0;  // those of gaps_ that are over 1.5 periods
    double late_sum_us_ = 0;
    Microseconds shortest_us_ = 0;
    Microseconds longest_us_ = 0;
    Gaps late_{};
    Gaps exceeded_{};
};

}  // namespace cgw::traffic
