// TCP as the hub and its clients need it: addresses as people write them, sockets that never block.
#pragma once

#include <sys/socket.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "media/descriptor.hpp"

namespace cgw::media {

struct HostPort {
    std::string host;
    std::uint16_t port = 0;
};

// "127.0.0.1:29536", "localhost:29536", "[::1]:29536"; both parts are needed, the port is 0..65535.
base::Result<HostPort> parse_host_port(std::string_view text);

struct Address {
    sockaddr_storage storage{};
    socklen_t length = 0;

    std::string text() const;  // "127.0.0.1:29536", "[::1]:29536"
};

// All addresses of a host, at least one. Asks the system, which takes time when `host` is a name.
base::Result<std::vector<Address>> resolve(const HostPort& where);

// A socket that listens; port 0 takes a free one.
base::Result<Descriptor> listen_on(const HostPort& where);

Address local_address(int socket);

// Small messages are sent at once, the kernel keeps at most about `bytes` of them for a slow peer, and a peer
// that has vanished is noticed within a minute also when there is nothing to send.
void prepare_stream(int socket, int bytes);

struct Received {
    std::string_view bytes;  // empty: nothing has come
    bool ended = false;      // the other end has closed, or `error` happened
    int error = 0;
};

using ReceiveBuffer = std::array<char, 16 * 1024>;

// Reads once; never blocks.
Received receive(int socket, ReceiveBuffer& buffer);

}  // namespace cgw::media
