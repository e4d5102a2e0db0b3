#include "canopen/sync.hpp"

namespace cgw::canopen {

SyncConsumer::Sync SyncConsumer::receive(const frame::Frame& frame) const {
    if (frame.id != cob_id_ || frame.extended || frame.remote) {
        return {};
    }
    if (frame.length != (counter_overflow_ == 0 ? 0 : 1)) {
        return {Sync::Kind::wrong_length, 0};
    }
    return {Sync::Kind::sync, frame.length == 0 ? std::uint8_t{0} : frame.data[0]};
}

void SyncProducer::start(Time now) {
    counter_ = 1;
    refused_ = false;
    deadline_ = period_ == 0 ? never : now;
}

frame::Frame SyncProducer::next_frame() const {
    frame::Frame frame;
    frame.id = cob_id_;
    if (counter_overflow_ != 0) {
        frame.length = 1;
        frame.data[0] = counter_;
    }
    return frame;
}

Time SyncProducer::poll(Time now, frame::FramePort& port) {
    if (now < deadline_) {
        return deadline_;
    }
    refused_ = !port.send(next_frame());
    if (refused_) {
        return never;
    }
    counter_ = counter_ >= counter_overflow_ ? std::uint8_t{1} : static_cast<std::uint8_t>(counter_ + 1);
    deadline_ += ((now - deadline_) / period_ + 1) * period_;
    return deadline_;
}

}  // namespace cgw::canopen
