#include "media/send_queue.hpp"

#include <sys/socket.h>

#include <cerrno>

namespace cgw::media {

bool SendQueue::add(std::string_view message, std::size_t limit) {
    if (size() + message.size() > limit) {
        return false;
    }
    bytes_ += message;
    return true;
}

int SendQueue::flush(int socket) {
    int error = 0;
    while (!empty() && error == 0) {
        const ssize_t taken = ::send(socket, bytes_.data() + sent_, size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (taken >= 0) {
            sent_ += static_cast<std::size_t>(taken);
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    // Moved to the front only when that is less work than what was sent.
    if (sent_ >= size()) {
        bytes_.erase(0, sent_);
        sent_ = 0;
    }
    return error == EAGAIN || error == EWOULDBLOCK ? 0 : error;
}

void SendQueue::clear() {
    bytes_.clear();
    sent_ = 0;
}

}  // namespace cgw::media
