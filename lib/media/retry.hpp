// When to try again to connect: at once, soon after a loss, then at growing distances of at most one second.
#pragma once

#include <algorithm>

#include "media/channel.hpp"

namespace cgw::media {

class Retry {
  public:
    static constexpr Time shortest = 50'000;
    static constexpr Time longest = 1'000'000;

    // A connection that worked is gone.
    void lost(Time now) {
        delay_ = shortest;
        due_ = now + delay_;
    }
    // An attempt was in vain.
    void failed(Time now) {
        due_ = now + delay_;
        delay_ = std::min(2 * delay_, longest);
    }
    void connected() { due_ = never; }

    Time due() const { return due_; }

  private:
    Time delay_ = shortest;
    Time due_ = 0;
};

}  // namespace cgw::media
