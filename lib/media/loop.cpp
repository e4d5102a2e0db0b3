#include "media/loop.hpp"

#include <sys/signalfd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>

namespace cgw::media {
namespace {

template <typename Clock>
std::uint64_t microseconds_of() {
    const auto since = Clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(since).count());
}

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

Time steady_now() {
    return microseconds_of<std::chrono::steady_clock>();
}

std::uint64_t wall_clock_now() {
    return microseconds_of<std::chrono::system_clock>();
}

void ChannelSource::watch(std::vector<pollfd>& entries) const {
    entries.push_back({channel_.descriptor(), channel_.events(), 0});
}

void ChannelSource::service(std::span<const pollfd>, Time now) {
    channel_.service(now, listener_);
}

void Timer::service(std::span<const pollfd>, Time now) {
    at_ = ring_(now);
}

Signals::Signals(std::initializer_list<int> numbers, std::function<void(int number)> taken)
    : taken_(std::move(taken)) {
    sigset_t set;
    ::sigemptyset(&set);
    for (const int number : numbers) {
        ::sigaddset(&set, number);
    }
    ::pthread_sigmask(SIG_BLOCK, &set, &before_);
    descriptor_ = Descriptor(::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC));
    if (!descriptor_) {
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        fail("signalfd");
    }
}

Signals::~Signals() {
    // What came after the loop has ended, such as a second interrupt, has no effect any more.
    while (next() != 0) {
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

int Signals::next() const {
    signalfd_siginfo info{};
    return ::read(descriptor_.get(), &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo)
                                                                        : 0;
}

void Signals::watch(std::vector<pollfd>& entries) const {
    entries.push_back({descriptor_.get(), POLLIN, 0});
}

void Signals::service(std::span<const pollfd>, Time) {
    for (int number = next(); number != 0; number = next()) {
        taken_(number);
    }
}

void Loop::run() {
    stopped_ = false;
    while (!stopped_) {
        turn();
    }
}

void Loop::turn(Time latest) {
    entries_.clear();
    ends_.clear();
    for (const Source* source : sources_) {
        source->watch(entries_);
        ends_.push_back(entries_.size());
        latest = std::min(latest, source->deadline());
    }
    wait(latest);
    serve();
}

void Loop::wait(Time until) {
    constexpr Time second = 1'000'000;
    const Time now = clock_();
    const Time left = until > now ? until - now : 0;
    const timespec limit{static_cast<time_t>(left / second), static_cast<long>(left % second * 1000)};
    if (::ppoll(entries_.data(), entries_.size(), until == never ? nullptr : &limit, nullptr) < 0) {
        if (errno != EINTR) {
            fail("ppoll");
        }
        for (pollfd& entry : entries_) {
            entry.revents = 0;
        }
    }
}

void Loop::serve() {
    const Time now = clock_();
    std::size_t begin = 0;
    // A source may add another one; it has its turn the next time.
    for (std::size_t i = 0; i < ends_.size(); ++i) {
        const std::span<const pollfd> own(entries_.data() + begin, ends_[i] - begin);
        begin = ends_[i];
        const bool ready =
            std::any_of(own.begin(), own.end(), [](const pollfd& e) { return e.revents != 0; });
        if (ready || sources_[i]->deadline() <= now) {
            sources_[i]->service(own, now);
        }
    }
}

}  // namespace cgw::media
