#include "media/can_bit_rate.hpp"

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "media/descriptor.hpp"

namespace cgw::media {
namespace {

using Bytes = std::span<const std::uint8_t>;

// The content of the attribute `type` in a row of attributes.
std::optional<Bytes> attribute(Bytes attributes, unsigned type) {
    constexpr unsigned flags = NLA_F_NESTED | NLA_F_NET_BYTEORDER;
    while (attributes.size() >= sizeof(nlattr)) {
        nlattr header{};
        std::memcpy(&header, attributes.data(), sizeof header);
        if (header.nla_len < sizeof header || header.nla_len > attributes.size()) {
            break;
        }
        if ((header.nla_type & ~flags) == type) {
            return attributes.subspan(sizeof header, header.nla_len - sizeof header);
        }
        attributes = attributes.subspan(std::min<std::size_t>(NLA_ALIGN(header.nla_len), attributes.size()));
    }
    return std::nullopt;
}

bool ask(const Descriptor& socket, unsigned index) {
    struct {
        nlmsghdr header;
        ifinfomsg link;
    } request{};
    request.header.nlmsg_len = sizeof request;
    request.header.nlmsg_type = RTM_GETLINK;
    request.header.nlmsg_flags = NLM_F_REQUEST;
    request.link.ifi_index = static_cast<int>(index);
    return ::send(socket.get(), &request, sizeof request, 0) == sizeof request;
}

}  // namespace

std::optional<std::uint32_t> bit_rate_in(Bytes message) {
    constexpr std::size_t front = NLMSG_LENGTH(NLMSG_ALIGN(sizeof(ifinfomsg)));
    nlmsghdr header{};
    if (message.size() < front) {
        return std::nullopt;
    }
    std::memcpy(&header, message.data(), sizeof header);
    if (header.nlmsg_type != RTM_NEWLINK) {
        return std::nullopt;
    }
    const auto info = attribute(message.subspan(front), IFLA_LINKINFO);
    const auto kind = info ? attribute(*info, IFLA_INFO_KIND) : std::nullopt;
    constexpr std::string_view can("can", 4);  // with its closing zero
    if (!kind || kind->size() != can.size() || std::memcmp(kind->data(), can.data(), can.size()) != 0) {
        return std::nullopt;
    }
    const auto data = attribute(*info, IFLA_INFO_DATA);
    const auto timing = data ? attribute(*data, IFLA_CAN_BITTIMING) : std::nullopt;
    std::uint32_t rate = 0;  // the first member of can_bittiming
    if (!timing || timing->size() < sizeof rate) {
        return std::nullopt;
    }
    std::memcpy(&rate, timing->data(), sizeof rate);
    return rate == 0 ? std::nullopt : std::optional(rate);
}

std::optional<std::uint32_t> can_bit_rate(const std::string& interface_name) {
    const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
    const unsigned index = ::if_nametoindex(interface_name.c_str());
    if (!socket || index == 0 || !ask(socket, index)) {
        return std::nullopt;
    }
    constexpr int patience = 100;  // ms; the kernel has answered already
    pollfd entry{socket.get(), POLLIN, 0};
    std::array<std::uint8_t, 16384> answer{};
    if (::poll(&entry, 1, patience) != 1) {
        return std::nullopt;
    }
    const ssize_t size = ::recv(socket.get(), answer.data(), answer.size(), MSG_DONTWAIT);
    return size <= 0 ? std::nullopt : bit_rate_in(Bytes(answer).first(static_cast<std::size_t>(size)));
}

}  // namespace cgw::media
