// A CANopen master on the simulated bus that sends what it is told to in a rhythm, and remembers what it
// heard.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "master/master.hpp"
#include "simulation/bus.hpp"

namespace cgw::simulation {

class MasterNode final : public Participant, public master::Listener {
  public:
    MasterNode(Bus& bus, std::uint8_t server_node_id, Time sdo_timeout);

    Time poll(Time now) override;
    void receive(const frame::Frame& frame, Time now) override { master_.receive(frame, now); }
    void boot_up(std::uint8_t node_id, Time now) override;
    void heartbeat(std::uint8_t node_id, canopen::NmtState state, Time now) override;
    void process_data(const frame::Frame& frame, Time now) override;

    master::Master& master() { return master_; }

    // Sends the frame now and from then on every `period`: a receive PDO of the gateway, a heartbeat. A frame
    // with the same identifier takes the place of the former one.
    void produce(const frame::Frame& frame, Time period);
    void stop_producing(std::uint32_t id) { produced_.erase(id); }

    struct Event {
        Time time = 0;
        std::uint8_t node_id = 0;
        canopen::NmtState state = canopen::NmtState::initialising;  // initialising: boot-up
    };
    const std::vector<Event>& boot_ups() const { return boot_ups_; }
    static constexpr std::ptrdiff_t most_heartbeats = 1'000'000;  // older ones are forgotten
    const std::vector<Event>& heartbeats() const { return heartbeats_; }

    struct Received {
        frame::Frame last;
        Time time = 0;
        std::uint64_t count = 0;
    };
    // Nothing before the first frame with that identifier.
    std::optional<Received> received(std::uint16_t cob_id) const;

  private:
    struct Produced {
        frame::Frame frame;
        Time period = 0;
        Time due = 0;
    };

    frame::FramePort* port_;
    master::Master master_;
    std::map<std::uint32_t, Produced> produced_;
    std::vector<Event> boot_ups_;
    std::vector<Event> heartbeats_;
    std::map<std::uint32_t, Received> received_;
};

}  // namespace cgw::simulation
