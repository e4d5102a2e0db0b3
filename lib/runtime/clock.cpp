#include "runtime/clock.hpp"

#include <algorithm>

namespace cgw::runtime {

Time RunClock::at(Time steady) {
    steady = std::max(steady, last_);
    const Time pause = steady - last_;
    left_out_ = pause > longest_pause ? pause : 0;
    total_left_out_ += left_out_;
    last_ = steady;
    return steady - start_ - total_left_out_;
}

}  // namespace cgw::runtime
