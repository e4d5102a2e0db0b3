#include "media/hub_client.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace cgw::media {
namespace {

// Beyond the limit for frames, so that a client who is behind with them still gets its answers.
constexpr std::size_t room_for_answers = 4096;
constexpr std::size_t longest_answer = MessageStream::longest;

}  // namespace

HubClient::HubClient(Descriptor socket, std::string name, const HubLimits& limits, Time now)
    : socket_(std::move(socket)),
      name_(std::move(name)),
      limits_(limits),
      open_until_(now + limits.opening) {}

pollfd HubClient::entry() const {
    const bool sends = !queue_.empty() && quiet_until_ == 0;
    const int events = (takes_answers() ? POLLIN : 0) | (sends ? POLLOUT : 0);
    return {socket_.get(), static_cast<short>(events), 0};
}

Time HubClient::deadline() const {
    if (stalled_ && takes_answers()) {
        return 0;
    }
    const Time opening = bus_.empty() ? open_until_ : never;
    const Time stuck = queue_.empty() ? never : progress_ + limits_.stuck;
    const Time quiet = quiet_until_ != 0 && !queue_.empty() ? quiet_until_ : never;
    return std::min({opening, stuck, quiet});
}

void HubClient::enter_raw_mode(Time now) {
    raw_ = true;
    answer(message_of("ok"), now);
    flush(now);
    quiet_until_ = now + limits_.quiet_start;
}

void HubClient::receive(short revents, Time now) {
    if (!takes_answers()) {
        if ((revents & (POLLHUP | POLLERR)) != 0) {
            leave("has closed the connection");
        }
        return;
    }
    ReceiveBuffer buffer;
    const Received received = media::receive(socket_.get(), buffer);
    if (received.ended) {
        leave(received.error == 0 ? "has closed the connection" : std::strerror(received.error));
    }
    if (!received.bytes.empty()) {
        input_.append(received.bytes);
        quiet_until_ = 0;
    }
    flush(now);
}

MessageStream::Item HubClient::next(std::string_view& text) {
    stalled_ = !takes_answers();
    return gone() || stalled_ ? MessageStream::Item::none : input_.next(text);
}

bool HubClient::takes_answers() const {
    return queue_.size() + longest_answer <= limits_.queued_bytes + room_for_answers;
}

bool HubClient::add(std::string_view message, std::size_t limit, Time now) {
    if (queue_.empty()) {
        progress_ = now;
    }
    return queue_.add(message, limit);
}

void HubClient::answer(std::string_view message, Time now) {
    add(message, limits_.queued_bytes + room_for_answers, now);
}

void HubClient::offer(std::string_view message, Time now) {
    if (tell_lost(now) && add(message, limits_.queued_bytes, now)) {
        return;
    }
    flush(now);
    if (!tell_lost(now) || !add(message, limits_.queued_bytes, now)) {
        ++lost_;
        ++untold_;
    }
}

// True when there is nothing left to tell.
bool HubClient::tell_lost(Time now) {
    if (untold_ != 0 && add(lost_message(untold_), limits_.queued_bytes, now)) {
        untold_ = 0;
    }
    return untold_ == 0;
}

void HubClient::flush(Time now) {
    if (gone() || quiet_until_ > now) {
        return;
    }
    quiet_until_ = 0;
    const std::size_t before = queue_.size();
    const int error = queue_.flush(socket_.get());
    if (error != 0) {
        leave(std::strerror(error));
    }
    if (queue_.size() != before) {
        progress_ = now;
    }
    if (queue_.empty()) {
        tell_lost(now);
    }
}

void HubClient::check(Time now) {
    if (bus_.empty() && now >= open_until_) {
        leave(fmt::format("has opened no bus for {} s", limits_.opening / 1'000'000));
    } else if (!queue_.empty() && now >= progress_ + limits_.stuck) {
        leave(fmt::format("has taken nothing for {} s", limits_.stuck / 1'000'000));
    }
}

void HubClient::leave(std::string_view reason) {
    if (!gone()) {
        reason_ = reason;
    }
}

}  // namespace cgw::media
