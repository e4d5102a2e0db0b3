#include "link/outbox.hpp"

#include <bit>

namespace cgw::link {

void Outbox::put(std::size_t place, const frame::Frame& frame) {
    frames_[place] = frame;
    waiting_ |= 1U << place;
}

bool Outbox::send(frame::FramePort& port) {
    while (waiting_ != 0) {
        const auto place = static_cast<std::size_t>(std::countr_zero(waiting_));
        if (!port.send(frames_[place])) {
            return false;
        }
        waiting_ &= waiting_ - 1;
    }
    return true;
}

}  // namespace cgw::link
