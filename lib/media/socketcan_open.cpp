#include <ifaddrs.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
// After net/if.h, which lacks IFF_LOWER_UP.
#include <fmt/format.h>
#include <linux/if.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "media/socketcan_channel.hpp"

namespace cgw::media {
namespace {

// Bytes of the kernel for frames that were not taken yet, as far as it permits: some 50 ms of a full 1 Mbit/s
// bus.
constexpr int receive_buffer = 1 << 20;

CanSocket not_now(std::string_view reason) {
    return {Descriptor(), std::string(reason), false};
}
CanSocket out_of_place(std::string_view reason) {
    return {Descriptor(), std::string(reason), true};
}

template <typename Value>
bool set_option(const Descriptor& socket, int level, int name, const Value& value) {
    return ::setsockopt(socket.get(), level, name, &value, sizeof value) == 0;
}

// The controller's state from error frames, the number of dropped frames with each frame.
bool set_options(const Descriptor& socket) {
    constexpr can_err_mask_t errors = CAN_ERR_CRTL | CAN_ERR_BUSOFF;
    set_option(socket, SOL_SOCKET, SO_RCVBUF, receive_buffer);  // the kernel's own size will do as well
    return set_option(socket, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, errors) &&
           set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, int{1});
}

// All 32 bits of them: the carrier bit is beyond those that an ioctl gives.
std::optional<unsigned> interface_flags(const std::string& name) {
    ifaddrs* list = nullptr;
    if (::getifaddrs(&list) != 0) {
        return std::nullopt;
    }
    std::optional<unsigned> flags;
    for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
        if (name == entry->ifa_name) {
            flags = entry->ifa_flags;
        }
    }
    ::freeifaddrs(list);
    return flags;
}

bool bind_to(const Descriptor& socket, unsigned index) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(index);
    return ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

}  // namespace

CanSocket open_can_socket(const std::string& name) {
    Descriptor socket(::socket(AF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
    if (!socket) {
        return errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT
                   ? out_of_place("this kernel has no CAN support")
                   : not_now(std::strerror(errno));
    }
    const unsigned index = ::if_nametoindex(name.c_str());
    if (index == 0) {
        return out_of_place(no_such_interface);
    }
    if (!set_options(socket)) {
        return not_now(std::strerror(errno));
    }
    if (!bind_to(socket, index)) {
        return errno == ENODEV ? out_of_place("it is no CAN interface") : not_now(std::strerror(errno));
    }
    const std::optional<unsigned> flags = interface_flags(name);
    if (flags && (*flags & IFF_UP) == 0) {
        return not_now(interface_down);
    }
    if (flags && (*flags & IFF_LOWER_UP) == 0) {
        return not_now(bus_off);  // a CAN interface that is up loses its carrier by that alone
    }
    return {std::move(socket), {}, false};
}

base::Result<std::unique_ptr<Channel>> open_socketcan(const std::string& name) {
    if (const CanSocket attempt = open_can_socket(name); attempt.out_of_place) {
        return base::failure(fmt::format("{}: {}", name, attempt.reason));
    }
    return std::make_unique<SocketCanChannel>(name, open_can_socket);
}

}  // namespace cgw::media
