#include "master/command_queue.hpp"

#include "canopen/nmt.hpp"

namespace cgw::master {

bool CommandQueue::add(canopen::NmtCommand command, std::uint8_t node_id) {
    if (count_ == capacity) {
        return false;
    }
    waiting_[(first_ + count_) % capacity] = {command, node_id};
    ++count_;
    return true;
}

bool CommandQueue::send_pending(frame::FramePort& port) {
    while (count_ != 0) {
        const Command& next = waiting_[first_];
        if (!port.send(canopen::nmt_frame(next.command, next.node_id))) {
            return false;
        }
        first_ = (first_ + 1) % capacity;
        --count_;
    }
    return true;
}

}  // namespace cgw::master
