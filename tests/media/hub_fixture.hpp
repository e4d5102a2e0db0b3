// A hub whose time the test owns, and clients that are the other end of a socket pair: nothing waits, nothing
// is left to chance.
#pragma once

#include <poll.h>
#include <sys/socket.h>

#include <stdexcept>

#include "media/hub.hpp"

namespace cgw::media::test {

inline constexpr Time start_time = 5'000'000;
inline constexpr std::uint64_t frame_time = 23'424'242;

class HubBench {
  public:
    explicit HubBench(HubOptions options = {})
        : hub(
              std::move(options), [] { return frame_time; },
              [this](std::string_view line) { reports.emplace_back(line); }) {}

    // Serves until nobody wants anything any more.
    void settle() {
        for (int turns = 0; turns < 10'000; ++turns) {
            std::vector<pollfd> entries;
            hub.watch(entries);
            const int ready = ::poll(entries.data(), entries.size(), 0);
            if (ready == 0 && hub.deadline() > now) {
                return;
            }
            hub.service(entries, now);
        }
        throw std::runtime_error("the hub does not come to rest");
    }

    void pass(Time time) {
        now += time;
        settle();
    }

    Time now = start_time;
    std::vector<std::string> reports;
    Hub hub;
};

class RawClient {
  public:
    RawClient(HubBench& bench, std::string name) : bench_(bench) {
        int ends[2] = {-1, -1};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) {
            throw std::runtime_error("socketpair");
        }
        socket_ = Descriptor(ends[0]);
        bench.hub.join(Descriptor(ends[1]), std::move(name), bench.now);
    }

    // What the socket takes of it; the hub has heard that when this returns.
    std::size_t say(std::string_view text) {
        std::size_t said = 0;
        while (said < text.size()) {
            const ssize_t taken = ::send(socket_.get(), text.data() + said, text.size() - said, MSG_NOSIGNAL);
            if (taken > 0) {
                said += static_cast<std::size_t>(taken);
            }
            bench_.settle();
            if (taken <= 0) {
                break;
            }
        }
        return said;
    }

    // Everything the hub has said, without the line feeds before frames.
    std::string hear() {
        std::string heard;
        for (;;) {
            ReceiveBuffer buffer;
            const Received received = receive(socket_.get(), buffer);
            heard += received.bytes;
            closed_ = closed_ || received.ended;
            if (received.bytes.empty()) {
                break;
            }
            bench_.settle();
        }
        std::erase(heard, '\n');
        return heard;
    }

    // Says it, and hears what the hub says then.
    std::string ask(std::string_view text) {
        say(text);
        return hear();
    }

    void join(std::string_view bus) {
        ask("< open " + std::string(bus) + " >");
        ask("< rawmode >");
        ask("< echo >");  // ends the quiet time
    }

    bool closed() {
        hear();
        return closed_;
    }

  private:
    HubBench& bench_;
    Descriptor socket_;
    bool closed_ = false;
};

}  // namespace cgw::media::test
