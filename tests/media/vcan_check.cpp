// A program on a CAN interface, for the test in tests/judges/vcan: prints what its channel hears and answers
// frames.
//   media_vcan_check INTERFACE
//   media_vcan_check TTY KBIT      on a serial adapter
// A frame below 700h is answered with the next identifier; 7F0h starts a burst of 20 frames 500h; 7FFh ends
// the program.
#include <poll.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>

#include "channel_events.hpp"
#include "media/slcan_channel.hpp"
#include "media/socketcan_channel.hpp"
#include "support/recording_port.hpp"

namespace {

using namespace cgw;

constexpr std::uint32_t unanswered = 0x700;
constexpr std::uint32_t burst_request = 0x7F0;
constexpr std::uint32_t end_request = 0x7FF;
constexpr std::uint32_t burst_id = 0x500;
constexpr std::uint8_t burst_length = 20;
constexpr media::Time patience = 300'000'000;

media::Time steady_now() {
    using namespace std::chrono;
    return static_cast<media::Time>(
        duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count());
}

// Milliseconds until `deadline`, at most a second, rounded up.
int time_to_wait(media::Time deadline, media::Time now) {
    constexpr media::Time longest = 1'000'000;
    const media::Time left = deadline > now ? deadline - now : 0;
    return static_cast<int>((std::min(left, longest) + 999) / 1'000);
}

class Program final : public media::ChannelListener {
  public:
    explicit Program(media::Channel& channel) : channel_(channel) {}

    bool ended() const { return ended_; }

    void run(media::Time until) {
        for (media::Time now = steady_now(); !ended_ && now < until; now = steady_now()) {
            pollfd entry{channel_.descriptor(), channel_.events(), 0};
            ::poll(&entry, 1, time_to_wait(channel_.deadline(), now));
            channel_.service(steady_now(), *this);
            while (!to_send_.empty() && channel_.send(to_send_.front())) {
                to_send_.pop_front();
            }
            std::fflush(stdout);
        }
    }

    void frame(const frame::Frame& frame, media::Time /*now*/) override {
        fmt::print("frame {}\n", test::frame_text(frame));
        if (frame.id == end_request) {
            ended_ = true;
        } else if (frame.id == burst_request) {
            for (std::uint8_t i = 0; i < burst_length; ++i) {
                to_send_.push_back(test::make_frame(burst_id, {i}));
            }
        } else if (frame.id < unanswered || frame.extended) {
            to_send_.push_back(frame);
            ++to_send_.back().id;
        }
    }
    void link_changed(media::LinkState state, std::string_view reason, media::Time /*now*/) override {
        fmt::print("{} {}\n", state == media::LinkState::up ? "up" : "down", reason);
    }
    void frames_lost(std::uint64_t count, media::Time /*now*/) override { fmt::print("lost {}\n", count); }

  private:
    media::Channel& channel_;
    std::deque<frame::Frame> to_send_;
    bool ended_ = false;
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 2 && count != 3) {
        fmt::print(stderr, "usage: media_vcan_check INTERFACE | TTY KBIT\n");
        return 2;
    }
    const auto channel =
        count == 2 ? media::open_socketcan(arguments[1])
                   : media::open_slcan(arguments[1], static_cast<unsigned>(std::atoi(arguments[2])));
    if (!channel) {
        fmt::print("{}\n", channel.error().message);
        return 1;
    }
    Program program(**channel);
    program.run(steady_now() + patience);
    return program.ended() ? 0 : 3;
}
