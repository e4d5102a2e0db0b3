#include "media/socketcan_channel.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "media/can_bit_rate.hpp"
#include "media/socketcan_frame.hpp"

namespace cgw::media {
namespace {

// The kernel says when its socket has room, not when the interface's queue has: a refused frame is offered
// again after the time of a few frames.
constexpr Time offer_again = 1'000;

// Frames per service(), so that a flooded bus leaves time for the others.
constexpr int batch = 1'000;

std::string fault_text(int error) {
    switch (error) {
        case ENETDOWN:
            return std::string(interface_down);
        case ENODEV:
        case ENXIO:
            return std::string(no_such_interface);
        default:
            return std::strerror(error);
    }
}

// How many frames the kernel has dropped on this socket since it was opened; it says so once there are any.
void read_drop_count(msghdr& message, std::uint32_t& count) {
    for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
        if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SO_RXQ_OVFL) {
            std::memcpy(&count, CMSG_DATA(part), sizeof count);
        }
    }
}

}  // namespace

bool SocketCanChannel::send(const frame::Frame& frame) {
    if (!socket_ || !fault_.empty()) {
        return false;
    }
    const can_frame raw = to_kernel_frame(frame);
    ssize_t sent = -1;
    do {
        sent = ::send(socket_.get(), &raw, sizeof raw, MSG_DONTWAIT | MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    if (sent >= 0) {
        return true;
    }
    if (errno == EAGAIN || errno == ENOBUFS) {
        refused_ = true;
    } else {
        fault_ = fault_text(errno);
    }
    return false;
}

std::optional<std::uint32_t> SocketCanChannel::bit_rate() const {
    return can_bit_rate(name_);
}

short SocketCanChannel::events() const {
    return POLLIN;
}

Time SocketCanChannel::deadline() const {
    if (!socket_) {
        return retry_.due();
    }
    if (!fault_.empty()) {
        return now_;
    }
    return refused_ ? now_ + offer_again : never;
}

void SocketCanChannel::service(Time now, ChannelListener& listener) {
    now_ = now;
    refused_ = false;
    if (!socket_ && now >= retry_.due()) {
        connect(listener);
    }
    if (!socket_) {
        return;
    }
    receive(listener);
    if (!fault_.empty()) {
        socket_.close();
        retry_.lost(now);
        told_ = fault_;
        tell(LinkState::down, fault_, listener);
    }
}

void SocketCanChannel::connect(ChannelListener& listener) {
    CanSocket attempt = open_(name_);
    if (!attempt.descriptor) {
        retry_.failed(now_);
        if (attempt.reason != told_) {
            told_ = attempt.reason;
            tell(LinkState::down, attempt.reason, listener);
        }
        return;
    }
    socket_ = std::move(attempt.descriptor);
    retry_.connected();
    fault_.clear();
    told_.clear();
    dropped_ = 0;
    error_passive_ = false;
    tell(LinkState::up, "the interface is up", listener);
}

// What came before the interface went down is still there to be taken after the kernel has said so.
void SocketCanChannel::receive(ChannelListener& listener) {
    bool failed = false;
    for (int i = 0; i < batch; ++i) {
        const Received received = receive_one(listener);
        if (received == Received::nothing || (received == Received::failed && failed)) {
            return;
        }
        failed = failed || received == Received::failed;
    }
}

SocketCanChannel::Received SocketCanChannel::receive_one(ChannelListener& listener) {
    can_frame raw{};
    iovec part{&raw, sizeof raw};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(std::uint32_t))> control{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();

    const ssize_t length = ::recvmsg(socket_.get(), &message, MSG_DONTWAIT);
    if (length < 0 && errno == EINTR) {
        return Received::frame;
    }
    if (length < 0 && errno == EAGAIN) {
        return Received::nothing;
    }
    if (length <= 0) {
        fault_ = fault_text(length < 0 ? errno : ENODEV);
        return Received::failed;
    }
    std::uint32_t dropped = dropped_;
    read_drop_count(message, dropped);
    if (dropped != dropped_) {
        listener.frames_lost(dropped - dropped_, now_);
        dropped_ = dropped;
    }
    if (static_cast<std::size_t>(length) == sizeof raw) {
        take(raw, listener);
    }
    return Received::frame;
}

void SocketCanChannel::take(const can_frame& raw, ChannelListener& listener) {
    if (is_error_frame(raw)) {
        take_error(raw, listener);
    } else {
        listener.frame(from_kernel_frame(raw), now_);
    }
}

void SocketCanChannel::take_error(const can_frame& raw, ChannelListener& listener) {
    const ControllerReport report = controller_report(raw);
    if (report.overflow) {
        listener.frames_lost(1, now_);  // one at least: the controller does not count
    }
    if (report.bus_off) {
        fault_ = bus_off;
    } else if (report.error_passive && !error_passive_) {
        error_passive_ = true;
        tell(LinkState::up, "the controller is error-passive: nobody acknowledges, or the bus is disturbed",
             listener);
    } else if (report.error_active && error_passive_) {
        error_passive_ = false;
        tell(LinkState::up, "the controller is error-active again", listener);
    }
}

void SocketCanChannel::tell(LinkState state, const std::string& reason, ChannelListener& listener) {
    listener.link_changed(state, fmt::format("{}: {}", name_, reason), now_);
}

}  // namespace cgw::media
