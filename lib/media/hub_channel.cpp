#include "media/hub_channel.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace cgw::media {
namespace {

constexpr int kernel_buffer = 16 * 1024;  // frames that wait there are as good as sent, and grow old

// A port of this machine that nobody listens on may be given to the very socket that asks for it: TCP then
// connects the socket to itself, and keeps the hub from its port.
bool connected_to_itself(int socket) {
    Address peer;
    peer.length = sizeof peer.storage;
    return ::getpeername(socket, reinterpret_cast<sockaddr*>(&peer.storage), &peer.length) == 0 &&
           peer.text() == local_address(socket).text();
}

}  // namespace

HubChannel::HubChannel(std::string name, std::vector<Address> addresses, HubChannelOptions options)
    : name_(std::move(name)), addresses_(std::move(addresses)), options_(std::move(options)) {}

bool HubChannel::send(const frame::Frame& frame) {
    if (phase_ != Phase::up || !queue_.add(send_message(frame), options_.queued_bytes)) {
        return false;
    }
    flush();
    return true;
}

// A failure is dealt with in service(), which has a listener to tell.
void HubChannel::flush() {
    const int error = queue_.flush(socket_.get());
    send_error_ = send_error_ == 0 ? error : send_error_;
}

short HubChannel::events() const {
    if (phase_ == Phase::connecting) {
        return POLLOUT;
    }
    return static_cast<short>(POLLIN | (queue_.empty() ? 0 : POLLOUT));
}

Time HubChannel::deadline() const {
    switch (phase_) {
        case Phase::waiting:
            return retry_.due();
        case Phase::up:
            return send_error_ != 0 ? 0 : (asked_ == 0 ? heard_ : asked_) + options_.silence;
        default:
            return handshake_until_;
    }
}

void HubChannel::service(Time now, ChannelListener& listener) {
    if (phase_ == Phase::waiting) {
        if (now >= retry_.due()) {
            connect(now, listener);
        }
        return;
    }
    if (phase_ == Phase::connecting) {
        finish_connect(now, listener);
    }
    if (phase_ > Phase::connecting) {
        flush();
        receive(now, listener);
    }
    if (phase_ != Phase::waiting) {
        check(now, listener);
    }
}

void HubChannel::connect(Time now, ChannelListener& listener) {
    const Address& address = addresses_[address_];
    phase_ = Phase::connecting;
    handshake_until_ = now + options_.handshake;
    socket_ = Descriptor(::socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket_) {
        lose(std::strerror(errno), now, listener);
        return;
    }
    prepare_stream(socket_.get(), kernel_buffer);
    if (::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address.storage), address.length) == 0) {
        finish_connect(now, listener);
    } else if (errno != EINPROGRESS) {
        lose(std::strerror(errno), now, listener);
    }
}

void HubChannel::finish_connect(Time now, ChannelListener& listener) {
    pollfd entry{socket_.get(), POLLOUT, 0};
    if (::poll(&entry, 1, 0) <= 0) {
        return;
    }
    int error = 0;
    socklen_t size = sizeof error;
    if (::getsockopt(socket_.get(), SOL_SOCKET, SO_ERROR, &error, &size) != 0) {
        error = errno;
    }
    if (error == 0 && connected_to_itself(socket_.get())) {
        error = ECONNREFUSED;
    }
    if (error == 0) {
        phase_ = Phase::greeting;
    } else {
        lose(std::strerror(error), now, listener);
    }
}

void HubChannel::receive(Time now, ChannelListener& listener) {
    ReceiveBuffer buffer;
    const Received received = media::receive(socket_.get(), buffer);
    if (!received.bytes.empty()) {
        input_.append(received.bytes);
        heard_ = now;
        asked_ = 0;
    }
    std::string_view text;
    while (phase_ != Phase::waiting) {
        const MessageStream::Item item = input_.next(text);
        if (item == MessageStream::Item::none) {
            break;
        }
        if (item == MessageStream::Item::message) {
            obey(text, now, listener);
        } else {
            lose("what answers there is no hub", now, listener);
        }
    }
    if (received.ended && phase_ != Phase::waiting) {
        lose(received.error == 0 ? "the hub has closed the connection" : std::strerror(received.error), now,
             listener);
    }
}

void HubChannel::obey(std::string_view text, Time now, ChannelListener& listener) {
    if (phase_ == Phase::up) {
        take(text, now, listener);
    } else {
        proceed(text, now, listener);
    }
}

void HubChannel::proceed(std::string_view text, Time now, ChannelListener& listener) {
    const std::size_t limit = options_.queued_bytes;
    std::string_view rest = text;
    if (next_word(rest) == "error") {
        lose(fmt::format("refused: {}", rest), now, listener);
    } else if (phase_ == Phase::greeting && text == "hi") {
        queue_.add(message_of("open " + options_.bus), limit);
        phase_ = Phase::opening;
    } else if (phase_ == Phase::opening && text == "ok") {
        queue_.add(message_of("rawmode"), limit);
        phase_ = Phase::entering;
    } else if (phase_ == Phase::entering && text == "ok") {
        rise(now, listener);
    } else {
        lose("what answers there is no hub", now, listener);
    }
    if (phase_ != Phase::waiting) {
        flush();
    }
}

void HubChannel::take(std::string_view text, Time now, ChannelListener& listener) {
    const std::string_view word = next_word(text);
    if (word == "frame" || word == "rtr") {
        const auto frame = word == "frame" ? parse_frame(text) : parse_rtr(text);
        if (frame) {
            listener.frame(*frame, now);
        } else {
            listener.frames_lost(1, now);
        }
    } else if (const auto lost = parse_lost(text); word == "error" && lost) {
        listener.frames_lost(*lost, now);
    }
}

void HubChannel::rise(Time now, ChannelListener& listener) {
    phase_ = Phase::up;
    heard_ = now;
    asked_ = 0;
    retry_.connected();
    told_.clear();
    listener.link_changed(LinkState::up, fmt::format("{}: on bus {}", name_, options_.bus), now);
}

void HubChannel::check(Time now, ChannelListener& listener) {
    if (send_error_ != 0) {
        lose(std::strerror(send_error_), now, listener);
    } else if (phase_ != Phase::up) {
        if (now >= handshake_until_) {
            lose(phase_ == Phase::connecting ? "cannot be reached" : "does not answer", now, listener);
        }
    } else if (asked_ != 0) {
        if (now >= asked_ + options_.silence) {
            lose("does not answer any more", now, listener);
        }
    } else if (now >= heard_ + options_.silence) {
        asked_ = now;
        queue_.add(message_of("echo"), options_.queued_bytes);
        flush();
    }
}

void HubChannel::lose(std::string_view why, Time now, ChannelListener& listener) {
    const Phase reached = phase_;
    phase_ = Phase::waiting;
    socket_.close();
    input_.clear();
    queue_.clear();
    send_error_ = 0;
    if (reached == Phase::connecting && address_ + 1 < addresses_.size()) {
        ++address_;
        connect(now, listener);
        return;
    }
    address_ = 0;
    if (reached == Phase::up) {
        retry_.lost(now);
    } else {
        retry_.failed(now);
    }
    if (told_ != why) {
        told_ = why;
        listener.link_changed(LinkState::down, fmt::format("{}: {}", name_, why), now);
    }
}

}  // namespace cgw::media
