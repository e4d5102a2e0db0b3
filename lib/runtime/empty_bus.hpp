// A bus with nobody else on it: every frame leaves, none comes.
#pragma once

#include "media/channel.hpp"

namespace cgw::runtime {

class EmptyBus final : public media::Channel {
  public:
    bool send(const frame::Frame& /*frame*/) override { return up_; }
    int descriptor() const override { return -1; }
    short events() const override { return 0; }
    void service(media::Time now, media::ChannelListener& listener) override {
        if (!up_) {
            up_ = true;
            listener.link_changed(media::LinkState::up, "a bus inside the program, with nobody on it", now);
        }
    }
    media::Time deadline() const override { return up_ ? media::never : 0; }

  private:
    bool up_ = false;
};

}  // namespace cgw::runtime
