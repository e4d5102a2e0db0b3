#include "media/hub_channel.hpp"

#include <random>

#include "media/fuzz_seeds.hpp"
#include "media/hub.hpp"
#include "media/recording_listener.hpp"
#include "support/recording_port.hpp"

namespace cgw::media {
namespace {

using cgw::test::make_frame;
using test::RecordingListener;

constexpr Time long_enough = 30'000'000;  // for a slow machine; nobody waits for it when all is well

// No doubts about a hub that is slow because the machine is.
HubChannelOptions patient(std::string bus = "can0") {
    return {.bus = std::move(bus), .handshake = long_enough, .silence = long_enough, .queued_bytes = 4096};
}

struct Joined {
    Joined(Loop& loop, const HostPort& where, HubChannelOptions options = patient())
        : channel("hub:test", *resolve(where), std::move(options)), source(channel, listener) {
        loop.add(source);
    }

    RecordingListener listener;
    HubChannel channel;
    ChannelSource source;
};

// Loopback, but not the address from which connections are made: nobody takes the port of a hub that is away.
constexpr const char* hub_host = "127.83.0.1";

// Until `condition`; false when that does not come.
template <typename Condition>
bool runs_until(Loop& loop, Condition condition) {
    const Time end = loop.now() + long_enough;
    while (!condition()) {
        if (loop.now() >= end) {
            return false;
        }
        loop.turn(end);
    }
    return true;
}

std::unique_ptr<Hub> started_hub(std::uint16_t port = 0, HubOptions options = {}) {
    auto hub = std::make_unique<Hub>(
        std::move(options), [] { return 1'000'000U; }, [](std::string_view) {});
    const auto listening = hub->listen({hub_host, port});
    EXPECT_TRUE(listening) << listening.error().message;
    return hub;
}

HostPort place_of(const Hub& hub) {
    return *parse_host_port(hub.address());
}

TEST(HubChannel, joins_and_exchanges_frames) {
    Loop loop;
    const auto hub = started_hub();
    loop.add(*hub);
    Joined one(loop, place_of(*hub));
    Joined two(loop, place_of(*hub));
    EXPECT_FALSE(one.channel.send(make_frame(1, {})));  // not yet
    ASSERT_TRUE(
        runs_until(loop, [&] { return one.listener.links.size() == 1 && two.listener.links.size() == 1; }));
    EXPECT_EQ(one.listener.links.front(), "up hub:test: on bus can0");
    std::vector<frame::Frame> sent = {make_frame(0x123, {1, 2, 3, 4, 5, 6, 7, 8}), make_frame(0x7FF, {}),
                                      make_frame(0x1ABCDEF0, {0xFF}), make_frame(0x12, {9}),
                                      make_frame(0x705, {})};
    sent[2].extended = sent[3].extended = true;
    sent[4].remote = true;
    for (const frame::Frame& frame : sent) {
        EXPECT_TRUE(one.channel.send(frame));
    }
    EXPECT_TRUE(two.channel.send(make_frame(0x80, {7})));
    ASSERT_TRUE(runs_until(
        loop, [&] { return two.listener.frames.size() >= sent.size() && !one.listener.frames.empty(); }));
    EXPECT_EQ(two.listener.frames, sent);
    EXPECT_EQ(one.listener.frames, std::vector<frame::Frame>{make_frame(0x80, {7})});
}

TEST(HubChannel, says_not_now_when_the_hub_does_not_keep_up_and_loses_nothing) {
    Loop loop;
    const auto hub = started_hub();
    loop.add(*hub);
    Joined one(loop, place_of(*hub));
    Joined two(loop, place_of(*hub));
    ASSERT_TRUE(
        runs_until(loop, [&] { return one.listener.links.size() == 1 && two.listener.links.size() == 1; }));
    std::vector<frame::Frame> sent;
    for (int refusals = 0; refusals < 3; loop.turn(loop.now())) {
        frame::Frame next = make_frame(0, {1, 2, 3, 4, 5, 6, 7, 8});
        next.extended = true;
        next.id = static_cast<std::uint32_t>(sent.size());
        while (one.channel.send(next)) {
            sent.push_back(next);
            next.id = static_cast<std::uint32_t>(sent.size());
        }
        ++refusals;
    }
    ASSERT_TRUE(
        runs_until(loop, [&] { return two.listener.frames.size() + two.listener.lost >= sent.size(); }));
    EXPECT_EQ(two.listener.lost, 0U);
    EXPECT_EQ(two.listener.frames, sent);
}

TEST(HubChannel, comes_back_when_the_hub_does) {
    Loop loop;
    auto hub = started_hub();
    const HostPort place = place_of(*hub);
    Joined one(loop, place);
    for (std::size_t round = 0; round < 3; ++round) {
        Loop with_hub;
        with_hub.add(*hub);
        with_hub.add(one.source);
        ASSERT_TRUE(runs_until(with_hub, [&] { return one.listener.links.size() == 2 * round + 1; }));
        EXPECT_EQ(one.listener.links.back(), "up hub:test: on bus can0");
        EXPECT_TRUE(one.channel.send(make_frame(1, {})));
        hub.reset();
        ASSERT_TRUE(runs_until(loop, [&] { return one.listener.links.size() >= 2 * round + 2; }));
        EXPECT_EQ(one.listener.links.back().substr(0, 4), "down");
        EXPECT_FALSE(one.channel.send(make_frame(1, {})));
        // Several attempts while nobody is there are told once.
        const std::size_t told = one.listener.links.size();
        const Time later = loop.now() + 5 * Retry::shortest;
        while (loop.now() < later) {
            loop.turn(later);
        }
        EXPECT_LE(one.listener.links.size(), told + 1);
        EXPECT_EQ(one.listener.links.back(), "down hub:test: Connection refused");
        one.listener.links.resize(2 * round + 2);
        hub = started_hub(place.port);
    }
}

TEST(HubChannel, says_why_the_hub_refuses_it) {
    Loop loop;
    const auto hub = started_hub(0, {.buses = {"can1"}, .limits = {}});
    loop.add(*hub);
    Joined one(loop, place_of(*hub));
    ASSERT_TRUE(runs_until(loop, [&] { return !one.listener.links.empty(); }));
    EXPECT_EQ(one.listener.links.front(), "down hub:test: refused: no bus can0; there is can1");
}

TEST(HubChannel, says_that_the_hub_is_full) {
    Loop loop;
    const auto hub = started_hub(0, {.buses = {}, .limits = {.clients = 0}});
    loop.add(*hub);
    Joined one(loop, place_of(*hub));
    ASSERT_TRUE(runs_until(loop, [&] { return !one.listener.links.empty(); }));
    EXPECT_EQ(one.listener.links.front(), "down hub:test: refused: the hub is full");
}

// A server that says what the test wants; its channel lives in a time of its own.
class Impostor {
  public:
    explicit Impostor(HubChannelOptions options = {})
        : listener_(*listen_on({"127.0.0.1", 0})),
          channel("hub:test", *resolve(*parse_host_port(local_address(listener_.get()).text())),
                  std::move(options)) {}

    void serve(Time passes = 0) {
        now += passes;
        channel.service(now, listener);
    }

    // Lets the channel connect.
    void accept() {
        serve();
        client_ = Descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK));
        for (int i = 0; i < 10'000 && !client_; ++i) {
            pollfd entry{listener_.get(), POLLIN, 0};
            ::poll(&entry, 1, 1000);
            client_ = Descriptor(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK));
        }
        prepare_stream(client_.get(), 64 * 1024);
        settle(POLLOUT);
    }

    void say(std::string_view text) {
        ASSERT_EQ(::send(client_.get(), text.data(), text.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(text.size()));
        settle(POLLIN);
    }

    // What the channel has said, once it has.
    std::string hear() {
        pollfd entry{client_.get(), POLLIN, 0};
        ::poll(&entry, 1, 10'000);
        ReceiveBuffer buffer;
        return std::string(receive(client_.get(), buffer).bytes);
    }

    void join() {
        accept();
        say("< hi >");
        EXPECT_EQ(hear(), "< open can0 >");
        say("< ok >");
        EXPECT_EQ(hear(), "< rawmode >");
        say("< ok >");
    }

    void close() {
        client_.close();
        settle(POLLIN);
    }

  private:
    // Serves when what the test has done has reached the channel.
    void settle(short events) {
        pollfd entry{channel.descriptor(), events, 0};
        ::poll(&entry, 1, 10'000);
        serve();
    }

    Descriptor listener_;
    Descriptor client_;

  public:
    Time now = 5'000'000;
    RecordingListener listener;
    HubChannel channel;
};

TEST(HubChannel, takes_what_socketcand_says) {
    Impostor server;
    server.join();
    EXPECT_EQ(server.listener.links, std::vector<std::string>{"up hub:test: on bus can0"});
    server.say("< frame 123 23.424242 11 22 >< frame 00000001 1.000000 AB ><");
    server.say(" rtr 7 1.0 3 >< stat 1 2 3 4 >< error 004 1.000000 >< frame 124 1.000000  >");
    frame::Frame extended = make_frame(1, {0xAB});
    extended.extended = true;
    frame::Frame remote = make_frame(7, {0, 0, 0});
    remote.remote = true;
    EXPECT_EQ(server.listener.frames, (std::vector<frame::Frame>{make_frame(0x123, {0x11, 0x22}), extended,
                                                                 remote, make_frame(0x124, {})}));
    EXPECT_EQ(server.listener.lost, 0U);
    server.say(lost_message(17) + "< frame zzz 1.0 11 >");
    EXPECT_EQ(server.listener.lost, 18U);  // one could not be read
}

TEST(HubChannel, gives_up_a_server_that_is_no_hub) {
    for (const char* greeting :
         {"HTTP/1.1 400 Bad Request\r\n", "< ho >", "< ok >", "< hi >< hi >", "< hi >x"}) {
        Impostor server;
        server.accept();
        server.say(greeting);
        EXPECT_EQ(server.listener.links,
                  std::vector<std::string>{"down hub:test: what answers there is no hub"})
            << greeting;
    }
}

TEST(HubChannel, gives_up_a_message_without_end) {
    Impostor server;
    server.join();
    server.say("< frame " + std::string(1000, '1'));
    EXPECT_EQ(server.listener.links.back(), "down hub:test: what answers there is no hub");
}

TEST(HubChannel, gives_up_a_server_that_does_not_greet) {
    Impostor server;
    server.accept();
    EXPECT_EQ(server.channel.deadline(), server.now + HubChannelOptions{}.handshake);
    server.serve(HubChannelOptions{}.handshake - 1);
    EXPECT_TRUE(server.listener.links.empty());
    server.serve(1);
    EXPECT_EQ(server.listener.links, std::vector<std::string>{"down hub:test: does not answer"});
}

TEST(HubChannel, asks_a_silent_hub_for_an_echo_and_gives_it_up_without) {
    const Time silence = HubChannelOptions{}.silence;
    Impostor server;
    server.join();
    EXPECT_EQ(server.channel.deadline(), server.now + silence);
    server.serve(silence);
    EXPECT_EQ(server.hear(), "< echo >");
    server.say("< echo >");
    server.serve(silence);
    EXPECT_EQ(server.hear(), "< echo >");
    EXPECT_EQ(server.channel.deadline(), server.now + silence);
    server.serve(silence - 1);
    EXPECT_EQ(server.listener.links.size(), 1U);
    server.serve(1);
    EXPECT_EQ(server.listener.links.back(), "down hub:test: does not answer any more");
}

TEST(HubChannel, says_that_the_hub_has_closed_the_connection) {
    Impostor server;
    server.join();
    server.close();
    EXPECT_EQ(server.listener.links.back(), "down hub:test: the hub has closed the connection");
}

TEST(HubChannel, waits_longer_with_each_attempt_until_it_succeeds) {
    Impostor server;
    Time pause = Retry::shortest;
    for (int attempt = 0; attempt < 10; ++attempt) {
        server.accept();
        server.close();
        EXPECT_EQ(server.channel.descriptor(), -1);
        EXPECT_EQ(server.channel.deadline(), server.now + pause);
        server.serve(pause - 1);
        EXPECT_EQ(server.channel.descriptor(), -1);
        server.now += 1;
        pause = std::min(2 * pause, Retry::longest);
    }
    EXPECT_EQ(server.listener.links.size(), 1U);
    server.join();
    server.close();
    EXPECT_EQ(server.channel.deadline(), server.now + Retry::shortest);
}

TEST(HubChannel, tries_all_addresses_of_its_host) {
    Loop loop;
    const auto hub = started_hub();
    loop.add(*hub);
    const Descriptor nobody = *listen_on({"127.0.0.1", 0});
    Address closed = local_address(nobody.get());
    ::shutdown(nobody.get(), SHUT_RDWR);  // bound, but refusing
    RecordingListener listener;
    HubChannel channel("hub:test", {closed, resolve(place_of(*hub))->front()}, patient());
    ChannelSource source(channel, listener);
    loop.add(source);
    ASSERT_TRUE(runs_until(loop, [&] { return !listener.links.empty(); }));
    EXPECT_EQ(listener.links.front(), "up hub:test: on bus can0");
}

TEST(HubChannelFuzz, survives_every_stream_of_bytes_and_joins_again) {
    static const std::vector<std::string> parts = {
        "<",
        ">",
        "< hi >",
        "< ok >",
        "< frame ",
        "123 ",
        "1.000000 ",
        "1122 ",
        "< rtr ",
        "3 >",
        "< error ",
        "\n",
        " ",
        "< frame 123 1.0 11 >",
        "18446744073709551616 frames lost, this client is too slow >",
        "\xff"};
    for (std::uint32_t seed = 1; seed <= test::fuzz_seeds(100); ++seed) {
        std::mt19937 random(seed);
        Impostor server;
        for (int life = 0; life < 5; ++life) {
            if (random() % 2 == 0) {
                server.join();
            } else {
                server.accept();
            }
            for (int step = 0; step < 20 && server.channel.descriptor() >= 0; ++step) {
                std::string stream;
                for (std::uint32_t i = 0; i < 1 + random() % 20; ++i) {
                    stream += parts[random() % parts.size()];
                }
                server.say(stream);
                server.channel.send(make_frame(random() % 0x800, {1, 2}));
            }
            if (server.channel.descriptor() >= 0) {
                server.close();
            }
            server.now = server.channel.deadline();
        }
        server.join();
        ASSERT_EQ(server.listener.links.back(), "up hub:test: on bus can0") << "seed " << seed;
    }
}

}  // namespace
}  // namespace cgw::media
