#include "live/run.hpp"

#include <csignal>

#include <algorithm>

#include "media/loop.hpp"

namespace cgw::live {
namespace {

constexpr Time progress_period = 100'000;
constexpr Time offer_again = 20'000;  // what the channel did not take

class Listener final : public media::ChannelListener {
  public:
    explicit Listener(Verification& verification) : verification_(verification) {}

    void frame(const frame::Frame& frame, media::Time now) override { verification_.receive(frame, now); }
    void link_changed(media::LinkState state, std::string_view reason, media::Time) override {
        connection.up = state == media::LinkState::up;
        connection.reason = reason;
    }
    void frames_lost(std::uint64_t count, media::Time) override { connection.lost += count; }

    Connection connection;

  private:
    Verification& verification_;
};

}  // namespace

Connection run(media::Channel& channel, Verification& verification,
               const std::function<void(const Verification&)>& progress) {
    media::Loop loop;
    Listener listener(verification);
    media::ChannelSource source(channel, listener);
    media::Signals signals({SIGINT, SIGTERM}, [&](int) { verification.interrupt(); });
    loop.add(signals);
    loop.add(source);
    Time next_progress = 0;
    while (!verification.over()) {
        const Time now = loop.now();
        Time deadline = verification.poll(now);
        if (verification.pending()) {
            deadline = std::min(deadline, now + offer_again);
        }
        if (now >= next_progress) {
            progress(verification);
            next_progress = now + progress_period;
        }
        if (!verification.over()) {
            loop.turn(deadline);
        }
    }
    return listener.connection;
}

}  // namespace cgw::live
