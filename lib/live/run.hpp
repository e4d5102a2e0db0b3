// A verification over a real connection: one thread, which waits for frames, time and signals.
#pragma once

#include <functional>
#include <string>

#include "live/verification.hpp"
#include "media/channel.hpp"

namespace cgw::live {

struct Connection {
    bool up = false;  // now, or when it ended
    std::string
        reason;  // the last one: "hub:127.0.0.1:29536: nobody listens there"; empty when there was none
    std::uint64_t lost = 0;  // frames that were lost before they could be read
};

// Until the verification is over; SIGINT and SIGTERM interrupt it. `progress` is called now and then.
Connection run(media::Channel& channel, Verification& verification,
               const std::function<void(const Verification&)>& progress);

}  // namespace cgw::live
