// Somebody who sends one frame as fast as a bus carries it, for a while.
#pragma once

#include "frame/frame.hpp"
#include "simulation/bus.hpp"

namespace cgw::simulation {

class Jammer final : public Participant {
  public:
    explicit Jammer(Bus& bus) : port_(&bus.attach(*this, 1)) {}

    // From the next event on the bus until `end`, which may be canopen::never.
    void start(const frame::Frame& frame, Time end) {
        frame_ = frame;
        end_ = end;
    }

    Time poll(Time now) override {
        if (now >= end_) {
            return canopen::never;
        }
        port_->send(frame_);
        return end_;
    }

  private:
    frame::FramePort* port_;
    frame::Frame frame_;
    Time end_ = 0;
};

}  // namespace cgw::simulation
