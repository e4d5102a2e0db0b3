// One connection to the hub: its bus, what it says, and what waits for it.
#pragma once

#include <poll.h>

#include <string>
#include <string_view>

#include "media/channel.hpp"
#include "media/descriptor.hpp"
#include "media/send_queue.hpp"
#include "media/socketcand.hpp"
#include "media/tcp.hpp"

namespace cgw::media {

struct HubLimits {
    std::size_t clients = 64;
    // Of frames that wait for one client, about 1300. Beyond it new frames are lost for that client and
    // counted.
    std::size_t queued_bytes = 64 * 1024;
    // Time in microseconds in which a client must take something of what waits for it.
    Time stuck = 10'000'000;
    // Time in microseconds in which a client must have opened a bus.
    Time opening = 30'000'000;
    // Time in microseconds for which frames wait after the answer to `rawmode`, unless the client says
    // something: python-can and SavvyCAN expect that answer alone.
    Time quiet_start = 20'000;
};

class HubClient {
  public:
    HubClient(Descriptor socket, std::string name, const HubLimits& limits, Time now);

    const std::string& name() const { return name_; }
    const std::string& bus() const { return bus_; }
    std::uint64_t lost() const { return lost_; }
    bool takes_frames_of(std::string_view bus) const { return raw_ && !gone() && bus_ == bus; }

    pollfd entry() const;
    Time deadline() const;

    void open(std::string_view bus) { bus_ = bus; }
    void enter_raw_mode(Time now);

    // Reads once; what it says is then had from next().
    void receive(short revents, Time now);
    // None also while there is no room for answers: who does not read is not listened to.
    MessageStream::Item next(std::string_view& text);
    // It may have said more than next() has given, for lack of room.
    bool stalled() const { return stalled_; }

    void answer(std::string_view message, Time now);
    // A frame. A full queue loses it; the client is told how many as soon as there is room again.
    void offer(std::string_view message, Time now);
    void flush(Time now);
    // Lets go a client that is stuck or does not come to the point.
    void check(Time now);

    void leave(std::string_view reason);
    bool gone() const { return !reason_.empty(); }
    const std::string& reason() const { return reason_; }

  private:
    bool takes_answers() const;
    bool add(std::string_view message, std::size_t limit, Time now);
    bool tell_lost(Time now);

    Descriptor socket_;
    std::string name_;
    const HubLimits& limits_;
    std::string bus_;  // empty: none is open
    bool raw_ = false;
    bool stalled_ = false;
    MessageStream input_;
    SendQueue queue_;
    Time open_until_;
    Time quiet_until_ = 0;
    Time progress_ = 0;  // when it last took something, or the queue ceased to be empty
    std::uint64_t lost_ = 0;
    std::uint64_t untold_ = 0;  // of these, those that the client does not know of
    std::string reason_;
};

}  // namespace cgw::media
