#include "traffic/rhythm.hpp"

#include <algorithm>
#include <cmath>

namespace cgw::traffic {

void Gaps::add(Microseconds gap_us, const Place& place) {
    ++count;
    if (gap_us > longest_us) {
        longest_us = gap_us;
        behind = place;
    }
}

// The grace belongs to the first gap alone, which begins with the start and not with a frame.
bool Rhythm::judge(Microseconds gap_us, const Place& place) {
    const Microseconds grace = first_ ? start_grace_us : 0;
    const auto latest = static_cast<Microseconds>(longest_gap_periods * static_cast<double>(period_us_));
    const bool late = period_us_ != 0 && gap_us > latest + grace;
    if (late) {
        late_.add(gap_us, place);
    }
    if (monitoring_us_ != 0 && gap_us > monitoring_us_ + grace) {
        exceeded_.add(gap_us, place);
    }
    return late;
}

void Rhythm::take(const Place& place) {
    ++frames_;
    if (running_) {
        const Microseconds gap_us = place.time_us - last_us_;
        if (!first_) {
            shortest_us_ = gaps_ == 0 ? gap_us : std::min(shortest_us_, gap_us);
            longest_us_ = std::max(longest_us_, gap_us);
            sum_us_ += static_cast<double>(gap_us);
            ++gaps_;
        }
        if (judge(gap_us, place) && !first_) {
            ++late_gaps_;
            late_sum_us_ += static_cast<double>(gap_us);
        }
    }
    running_ = true;
    first_ = false;
    last_us_ = place.time_us;
}

void Rhythm::arm(const Place& place) {
    running_ = first_ = true;
    last_us_ = place.time_us;
}

void Rhythm::disarm(const Place& place) {
    if (running_) {
        judge(place.time_us - last_us_, place);
    }
    running_ = first_ = false;
}

Gaps Rhythm::late() const {
    return gaps_ != 0 && other_period() ? Gaps{} : late_;
}

double Rhythm::judged_mean_us() const {
    const bool all = other_period();
    const std::uint64_t count = all ? gaps_ : gaps_ - late_gaps_;
    const double sum = all ? sum_us_ : sum_us_ - late_sum_us_;
    return count == 0 ? 0 : sum / static_cast<double>(count);
}

double Rhythm::deviation() const {
    const std::uint64_t judged = other_period() ? gaps_ : gaps_ - late_gaps_;
    if (period_us_ == 0 || judged < fewest_gaps) {
        return 0;
    }
    const auto period = static_cast<double>(period_us_);
    const double deviation = (judged_mean_us() - period) / period;
    return std::abs(deviation) > largest_deviation ? deviation : 0;
}

}  // namespace cgw::traffic
