// Bytes on their way into a stream socket that must not block: whole messages only, within a limit.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cgw::media {

class SendQueue {
  public:
    // False: with it more than `limit` bytes would wait; nothing is added.
    bool add(std::string_view message, std::size_t limit);

    // Hands over what the socket takes now. 0, or the errno of a connection that is gone.
    int flush(int socket);

    std::size_t size() const { return bytes_.size() - sent_; }
    bool empty() const { return size() == 0; }
    void clear();

  private:
    std::string bytes_;
    std::size_t sent_ = 0;
};

}  // namespace cgw::media
