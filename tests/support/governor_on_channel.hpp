// A simulated governor whose CAN1 is a channel: the gateway is somewhere else.
#pragma once

#include <deque>

#include "media/loop.hpp"
#include "simulation/governor.hpp"
#include "simulation/plant.hpp"

namespace cgw::test {

class GovernorOnChannel final : public media::Source,
                                private media::ChannelListener,
                                private simulation::Participant {
  public:
    // Image and channel outlive it.
    GovernorOnChannel(const image::Image& image, media::Channel& channel, media::Time start)
        : channel_(channel),
          start_(start),
          bus_(simulation::bus_bit_rate_kbit(image.can1())),
          port_(bus_.attach(*this, 1000)),
          governor_(bus_, image) {}

    simulation::SimulatedGovernor& governor() { return governor_; }

    void watch(std::vector<pollfd>& entries) const override {
        entries.push_back({channel_.descriptor(), channel_.events(), 0});
    }
    void service(std::span<const pollfd> entries, media::Time now) override {
        bus_.run_until(now - start_);
        if (entries[0].revents != 0 || channel_.deadline() <= now) {
            channel_.service(now, *this);
        }
        bus_.run_until(now - start_);
        while (!leaving_.empty() && channel_.send(leaving_.front())) {
            leaving_.pop_front();
        }
    }
    media::Time deadline() const override {
        return std::min(channel_.deadline(), start_ + bus_.next_event());
    }

  private:
    void frame(const frame::Frame& frame, media::Time) override { port_.send(frame); }
    void link_changed(media::LinkState, std::string_view, media::Time) override { leaving_.clear(); }
    void frames_lost(std::uint64_t, media::Time) override {}
    simulation::Time poll(simulation::Time) override { return canopen::never; }
    void receive(const frame::Frame& frame, simulation::Time) override { leaving_.push_back(frame); }

    media::Channel& channel_;
    media::Time start_;
    simulation::Bus bus_;
    frame::FramePort& port_;
    simulation::SimulatedGovernor governor_;
    std::deque<frame::Frame> leaving_;
};

}  // namespace cgw::test
