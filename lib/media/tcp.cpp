#include "media/tcp.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>

namespace cgw::media {
namespace {

constexpr int waiting_connections = 16;

using AddressList = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

void set_option(int socket, int level, int name, int value) {
    // Only speed or comfort depends on these options.
    (void)::setsockopt(socket, level, name, &value, sizeof value);
}

base::Result<Descriptor> listen_at(const Address& address) {
    Descriptor socket(::socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket) {
        return base::failure(std::strerror(errno));
    }
    // A hub that is started again gets its port at once.
    set_option(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1);
    if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address.storage), address.length) != 0 ||
        ::listen(socket.get(), waiting_connections) != 0) {
        return base::failure(std::strerror(errno));
    }
    return socket;
}

}  // namespace

base::Result<HostPort> parse_host_port(std::string_view text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon == 0) {
        return base::failure(fmt::format("'{}' is not HOST:PORT", text));
    }
    std::string_view host = text.substr(0, colon);
    const std::string_view port_text = text.substr(colon + 1);
    if (host.front() == '[' && host.back() == ']') {
        host = host.substr(1, host.size() - 2);
    } else if (host.find(':') != std::string_view::npos) {
        return base::failure(fmt::format("'{}': an IPv6 address stands in brackets: [::1]:29536", text));
    }
    std::uint16_t port = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(port_text.data(), end, port);
    if (host.empty() || port_text.empty() || error != std::errc{} || stop != end) {
        return base::failure(fmt::format("'{}' is not HOST:PORT with a port 0..65535", text));
    }
    return HostPort{std::string(host), port};
}

std::string Address::text() const {
    std::array<char, NI_MAXHOST> host{};
    std::array<char, NI_MAXSERV> port{};
    if (::getnameinfo(reinterpret_cast<const sockaddr*>(&storage), length, host.data(), host.size(),
                      port.data(), port.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
        return "?";
    }
    return storage.ss_family == AF_INET6 ? fmt::format("[{}]:{}", host.data(), port.data())
                                         : fmt::format("{}:{}", host.data(), port.data());
}

base::Result<std::vector<Address>> resolve(const HostPort& where) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* found = nullptr;
    const int error = ::getaddrinfo(where.host.c_str(), std::to_string(where.port).c_str(), &hints, &found);
    if (error != 0) {
        return base::failure(fmt::format("host '{}': {}", where.host, ::gai_strerror(error)));
    }
    const AddressList list(found, &::freeaddrinfo);
    std::vector<Address> addresses;
    for (const addrinfo* entry = list.get(); entry != nullptr; entry = entry->ai_next) {
        Address address;
        std::memcpy(&address.storage, entry->ai_addr, entry->ai_addrlen);
        address.length = entry->ai_addrlen;
        addresses.push_back(address);
    }
    return addresses;
}

base::Result<Descriptor> listen_on(const HostPort& where) {
    const auto addresses = resolve(where);
    if (!addresses) {
        return tl::unexpected(addresses.error());
    }
    base::Result<Descriptor> socket;
    for (const Address& address : *addresses) {
        socket = listen_at(address);
        if (socket) {
            return socket;
        }
    }
    return base::failure(
        fmt::format("cannot listen on {}: {}", addresses->front().text(), socket.error().message));
}

Address local_address(int socket) {
    Address address;
    address.length = sizeof address.storage;
    if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address.storage), &address.length) != 0) {
        address.length = 0;
    }
    return address;
}

void prepare_stream(int socket, int bytes) {
    set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(socket, SOL_SOCKET, SO_SNDBUF, bytes);
    set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
    set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 30);
    set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 10);
    set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

Received receive(int socket, ReceiveBuffer& buffer) {
    const ssize_t size = ::recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (size > 0) {
        return {{buffer.data(), static_cast<std::size_t>(size)}, false, 0};
    }
    if (size == 0) {
        return {{}, true, 0};
    }
    const bool nothing = errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
    return nothing ? Received{} : Received{{}, true, errno};
}

}  // namespace cgw::media
