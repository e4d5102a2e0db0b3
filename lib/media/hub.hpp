// The virtual CAN bus between processes: a TCP server that speaks socketcand's protocol (socketcand.hpp),
// without interfaces behind it. Whatever a client sends on a bus, every other client of that bus gets, in the
// same order; python-can joins with its interface `socketcand`.
//
// Nobody waits for anybody. For a client that does not read fast enough frames pile up to a limit; then the
// newest are lost for this client alone, it is told how many, and after a while without any progress it is
// let go. What a client says wrong is answered with an error; a client that cannot be understood any more is
// let go.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "media/hub_client.hpp"
#include "media/loop.hpp"

namespace cgw::media {

struct HubOptions {
    std::vector<std::string> buses;  // empty: whatever name a client opens
    HubLimits limits;
};

struct HubCounters {
    std::uint64_t frames = 0;   // sent by clients
    std::uint64_t lost = 0;     // for slow clients; a frame counts once for each
    std::uint64_t refused = 0;  // messages answered with an error, and connections beyond the limit
};

class Hub final : public Source {
  public:
    // `clock` gives microseconds since 1970 for the time stamps of frames. `report` gets a line for people
    // when a client comes or goes.
    Hub(HubOptions options, std::function<std::uint64_t()> clock,
        std::function<void(std::string_view)> report);
    ~Hub();

    // The failure says what is in the way; port 0 takes a free one.
    base::Result<void> listen(const HostPort& where);
    // Where it listens: "127.0.0.1:29536".
    std::string address() const { return local_address(listener_.get()).text(); }

    // A connected stream socket becomes a client.
    void join(Descriptor socket, std::string name, Time now);

    std::size_t clients() const { return clients_.size(); }
    const HubCounters& counters() const { return counters_; }

    void watch(std::vector<pollfd>& entries) const override;
    void service(std::span<const pollfd> entries, Time now) override;
    Time deadline() const override;

  private:
    struct Command;
    static const Command commands[];

    void accept(Time now);
    void listen_to(HubClient& client, Time now);
    void obey(HubClient& client, std::string_view text, Time now);
    void open(HubClient& client, std::string_view words, Time now);
    void raw_mode(HubClient& client, std::string_view words, Time now);
    void send(HubClient& client, std::string_view words, Time now);
    void send_remote(HubClient& client, std::string_view words, Time now);
    void echo(HubClient& client, std::string_view words, Time now);
    void refuse(HubClient& client, std::string_view why, Time now);
    void distribute(HubClient& sender, const base::Result<frame::Frame>& frame, Time now);
    void let_go();

    HubOptions options_;
    std::function<std::uint64_t()> clock_;
    std::function<void(std::string_view)> report_;
    Descriptor listener_;
    Time listen_again_ = 0;  // until then the system has no room for another connection; 0: it has
    std::vector<std::unique_ptr<HubClient>> clients_;
    HubCounters counters_;
};

}  // namespace cgw::media
