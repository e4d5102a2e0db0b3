// Waits with poll(2) for whatever happens next: bytes, time, signals. One thread, no callbacks from
// elsewhere.
#pragma once

#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigset_t is of POSIX, not of <csignal>

#include <functional>
#include <initializer_list>
#include <span>
#include <vector>

#include "media/channel.hpp"
#include "media/descriptor.hpp"

namespace cgw::media {

// Microseconds of the steady clock, for Channel, Source and Loop.
Time steady_now();
// Microseconds since 1970, for time stamps.
std::uint64_t wall_clock_now();

// Something that a loop serves.
class Source {
  public:
    Source() = default;
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // Appends what it waits for; asked again before every wait. Entries with descriptor -1 are not waited
    // for.
    virtual void watch(std::vector<pollfd>& entries) const = 0;
    // Something of it is ready, or its deadline has come. `entries` are its own, with revents.
    virtual void service(std::span<const pollfd> entries, Time now) = 0;
    virtual Time deadline() const = 0;

  protected:
    ~Source() = default;
};

// A channel and who listens to it.
class ChannelSource final : public Source {
  public:
    ChannelSource(Channel& channel, ChannelListener& listener) : channel_(channel), listener_(listener) {}

    void watch(std::vector<pollfd>& entries) const override;
    void service(std::span<const pollfd> entries, Time now) override;
    Time deadline() const override { return channel_.deadline(); }

  private:
    Channel& channel_;
    ChannelListener& listener_;
};

// Calls `ring` when its time has come; `ring` says when it wants to be called next, or never.
class Timer final : public Source {
  public:
    Timer(Time at, std::function<Time(Time now)> ring) : at_(at), ring_(std::move(ring)) {}

    void set(Time at) { at_ = at; }

    void watch(std::vector<pollfd>&) const override {}
    void service(std::span<const pollfd> entries, Time now) override;
    Time deadline() const override { return at_; }

  private:
    Time at_;
    std::function<Time(Time now)> ring_;
};

// Takes these signals as long as it lives: instead of their usual effect `taken` is called, in the loop. One
// object at a time for the same signal; other threads must not let them through either.
class Signals final : public Source {
  public:
    Signals(std::initializer_list<int> numbers, std::function<void(int number)> taken);
    ~Signals();

    void watch(std::vector<pollfd>& entries) const override;
    void service(std::span<const pollfd> entries, Time now) override;
    Time deadline() const override { return never; }

  private:
    int next() const;  // 0: none has come

    std::function<void(int number)> taken_;
    sigset_t before_{};
    Descriptor descriptor_;
};

class Loop {
  public:
    explicit Loop(std::function<Time()> clock = steady_now) : clock_(std::move(clock)) {}

    // `source` must outlive the loop's work.
    void add(Source& source) { sources_.push_back(&source); }

    // Until stop(), which a source calls.
    void run();
    void stop() { stopped_ = true; }

    // Waits until something happens, at most until `latest`, and serves it.
    void turn(Time latest = never);

    Time now() const { return clock_(); }

  private:
    void wait(Time until);
    void serve();

    std::function<Time()> clock_;
    std::vector<Source*> sources_;
    std::vector<pollfd> entries_;
    std::vector<std::size_t> ends_;  // of each source's entries
    bool stopped_ = false;
};

}  // namespace cgw::media
