#include "media/loop.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "media/recording_listener.hpp"

namespace cgw::media {
namespace {

struct Pipe {
    Pipe() {
        int ends[2] = {-1, -1};
        EXPECT_EQ(::pipe2(ends, O_NONBLOCK), 0);
        read = Descriptor(ends[0]);
        write = Descriptor(ends[1]);
    }
    Descriptor read, write;
};

// A channel whose frames are the bytes that come through a pipe.
class PipeChannel final : public Channel {
  public:
    bool send(const frame::Frame&) override { return false; }
    int descriptor() const override { return pipe.read.get(); }
    short events() const override { return POLLIN; }
    void service(Time now, ChannelListener& listener) override {
        ++services;
        frame::Frame frame;
        while (::read(descriptor(), frame.data.data(), 1) == 1) {
            listener.frame(frame, now);
        }
        at = never;
    }
    Time deadline() const override { return at; }

    Pipe pipe;
    Time at = never;
    int services = 0;
};

TEST(Loop, serves_the_channel_that_has_something_and_no_other) {
    PipeChannel one, two;
    test::RecordingListener listener;
    ChannelSource first(one, listener), second(two, listener);
    Loop loop;
    loop.add(first);
    loop.add(second);
    ASSERT_EQ(::write(two.pipe.write.get(), "xy", 2), 2);
    loop.turn();
    EXPECT_EQ(one.services, 0);
    EXPECT_EQ(two.services, 1);
    EXPECT_EQ(listener.frames.size(), 2U);
}

TEST(Loop, serves_a_channel_whose_deadline_has_come) {
    PipeChannel channel;
    test::RecordingListener listener;
    ChannelSource source(channel, listener);
    Loop loop;
    loop.add(source);
    channel.at = loop.now() + 2000;
    const Time at = channel.at;
    while (channel.services == 0) {
        loop.turn();
    }
    EXPECT_GE(loop.now(), at);
}

TEST(Loop, waits_no_longer_than_it_is_told) {
    Loop loop;
    const Time until = loop.now() + 3000;
    loop.turn(until);
    EXPECT_GE(loop.now(), until);
    loop.turn(0);  // long past
}

TEST(Loop, timers_ring_in_time_and_say_when_they_want_to_ring_again) {
    Loop loop;
    std::vector<Time> rung;
    const Time start = loop.now();
    Timer timer(start + 500, [&](Time now) {
        rung.push_back(now);
        return rung.size() < 3 ? now + 500 : never;
    });
    Timer end(never, [&](Time) {
        loop.stop();
        return never;
    });
    loop.add(timer);
    loop.add(end);
    end.set(start + 20'000);
    loop.run();
    ASSERT_EQ(rung.size(), 3U);
    EXPECT_GE(rung[0], start + 500);
    EXPECT_GE(rung[1], rung[0] + 500);
    EXPECT_GE(loop.now(), start + 20'000);
}

TEST(Loop, runs_on_the_clock_it_is_given) {
    Time time = 1000;
    Loop loop([&] { return time += 100; });
    Time rung = 0;
    Timer timer(5000, [&](Time now) {
        rung = now;
        loop.stop();
        return never;
    });
    loop.add(timer);
    while (rung == 0) {
        loop.turn(0);
    }
    EXPECT_GE(rung, 5000U);
    EXPECT_LE(rung, 5200U);
}

TEST(Loop, takes_signals_instead_of_their_effect) {
    Loop loop;
    std::vector<int> taken;
    {
        Signals signals({SIGINT, SIGTERM, SIGUSR1}, [&](int number) {
            taken.push_back(number);
            if (number == SIGTERM) {
                loop.stop();
            }
        });
        loop.add(signals);
        ASSERT_EQ(::raise(SIGUSR1), 0);
        loop.turn();
        EXPECT_EQ(taken, std::vector<int>{SIGUSR1});
        ASSERT_EQ(::raise(SIGTERM), 0);
        loop.run();
        EXPECT_EQ(taken.back(), SIGTERM);
        ASSERT_EQ(::raise(SIGINT), 0);  // too late, and without effect
    }
    EXPECT_EQ(taken.size(), 2U);
    sigset_t blocked;
    ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
    EXPECT_EQ(::sigismember(&blocked, SIGTERM), 0);
}

}  // namespace
}  // namespace cgw::media
