// Boot-up message and heartbeat producer. The first heartbeat follows one period after the boot-up message
// really left; a frame the port did not take is offered again, with the state of that moment.
#pragma once

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::canopen {

class HeartbeatProducer {
  public:
    HeartbeatProducer() = default;
    // `period` in microseconds, 0: boot-up only.
    HeartbeatProducer(std::uint8_t node_id, Time period) : node_id_(node_id), period_(period) {}

    void boot_up();  // the boot-up message is to be sent, exactly once
    void silence();  // nothing more until the next boot-up
    // Out of turn: a heartbeat now, or the boot-up message where no heartbeat is configured (D58).
    void announce(Time now);
    // The reason to announce is gone: a boot-up message that still waits for that alone is not sent any more.
    void withdraw_announcement();

    // 1017h was written; `first` is when the first heartbeat of the new period is due.
    void set_period(Time period, Time first) {
        period_ = period;
        deadline_ = first;
        refused_ = false;
    }

    // Something is due that the port has not taken yet.
    bool pending() const { return boot_up_pending_ || refused_; }

    bool due(Time now) const { return boot_up_pending_ || now >= deadline_; }
    // Sends what is due. False: the port did not take it.
    bool send_due(NmtState state, Time now, frame::FramePort& port);

    // When time alone will make a heartbeat due.
    Time deadline() const { return refused_ ? never : deadline_; }

  private:
    void advance(Time now);

    std::uint8_t node_id_ = 0;
    bool boot_up_pending_ = false;
    bool only_announced_ = false;
    bool refused_ = false;
    Time period_ = 0;
    Time deadline_ = never;
};

}  // namespace cgw::canopen
