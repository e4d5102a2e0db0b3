// Telegrams that wait for a port that says "not now": one place per kind of telegram, holding the newest.
#pragma once

#include <array>
#include <cstdint>

#include "frame/frame.hpp"

namespace cgw::link {

class Outbox {
  public:
    static constexpr std::size_t capacity = 24;

    // `place` < capacity; smaller ones go first. A telegram still waiting there is replaced.
    void put(std::size_t place, const frame::Frame& frame);
    void withdraw(std::size_t place) { waiting_ &= ~(1U << place); }
    void clear() { waiting_ = 0; }
    bool pending() const { return waiting_ != 0; }
    bool pending(std::size_t place) const { return ((waiting_ >> place) & 1U) != 0; }

    // False: the port did not take all of it.
    bool send(frame::FramePort& port);

  private:
    std::array<frame::Frame, capacity> frames_{};
    std::uint32_t waiting_ = 0;  // bit = place
};

}  // namespace cgw::link
