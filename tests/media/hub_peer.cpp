// Joins a bus and answers every frame whose identifier is even with one whose identifier is one more and
// whose data is reversed. Says on standard output what its link does.
//   hub_peer hub:127.0.0.1:29536/can0
#include <csignal>
#include <cstdio>
#include <deque>
#include <exception>

#include "media/loop.hpp"
#include "media/open_channel.hpp"

namespace {

class Peer final : public cgw::media::ChannelListener {
  public:
    explicit Peer(cgw::media::Channel& channel) : channel_(channel) {}

    void frame(const cgw::frame::Frame& frame, cgw::media::Time) override {
        if (frame.id % 2 != 0) {
            return;
        }
        cgw::frame::Frame answer = frame;
        ++answer.id;
        for (std::size_t i = 0; i < frame.length; ++i) {
            answer.data[i] = frame.data[frame.length - 1U - i];
        }
        waiting_.push_back(answer);
        send();
    }

    void link_changed(cgw::media::LinkState state, std::string_view reason, cgw::media::Time) override {
        std::printf("%s %.*s\n", state == cgw::media::LinkState::up ? "up" : "down",
                    static_cast<int>(reason.size()), reason.data());
        std::fflush(stdout);
    }

    void frames_lost(std::uint64_t count, cgw::media::Time) override {
        std::printf("lost %llu\n", static_cast<unsigned long long>(count));
        std::fflush(stdout);
    }

    void send() {
        while (!waiting_.empty() && channel_.send(waiting_.front())) {
            waiting_.pop_front();
        }
    }

  private:
    cgw::media::Channel& channel_;
    std::deque<cgw::frame::Frame> waiting_;
};

int run(const char* bus) {
    const auto channel = cgw::media::open_channel(bus);
    if (!channel) {
        std::fprintf(stderr, "hub_peer: %s\n", channel.error().message.c_str());
        return 2;
    }
    Peer peer(**channel);
    cgw::media::Loop loop;
    cgw::media::Signals signals({SIGINT, SIGTERM}, [&](int) { loop.stop(); });
    cgw::media::ChannelSource source(**channel, peer);
    cgw::media::Timer retry(0, [&](cgw::media::Time now) {
        peer.send();
        return now + 1000;
    });
    loop.add(signals);
    loop.add(source);
    loop.add(retry);
    loop.run();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc == 2 ? argv[1] : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hub_peer: %s\n", error.what());
        return 70;
    }
}
