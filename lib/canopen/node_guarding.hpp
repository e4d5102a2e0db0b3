// Node guarding (CiA 301, 7.2.8.3), both ends: a master asks by remote frame, the node answers with its state
// and a bit that toggles; each side notices when the other goes missing. Superseded by heartbeat; a device
// has one or the other.
#pragma once

#include <cstdint>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::canopen {

// The node's end.
class GuardedNode {
  public:
    GuardedNode() = default;
    // Guard time (100Ch) in microseconds and life time factor (100Dh); the node misses its master after their
    // product, never when it is 0.
    GuardedNode(std::uint8_t node_id, Time guard_time, std::uint8_t factor)
        : node_id_(node_id), life_time_(guard_time * factor) {}

    // The next answer has toggle bit 0; the master is not missed before it has asked once.
    void boot_up();

    // True: the frame asks this node, and an answer is due.
    bool receive(const frame::Frame& frame, Time now);
    // Sends an answer that is due; the state is that of this moment. False: the port did not take it.
    bool send_due(NmtState state, frame::FramePort& port);
    bool pending() const { return due_; }

    // Time passes. Returns when the master will be missed.
    Time poll(Time now);
    bool master_lost() const { return lost_; }  // until it asks again

  private:
    std::uint8_t node_id_ = 0;
    Time life_time_ = 0;
    Time deadline_ = never;
    bool due_ = false;
    bool toggle_ = false;
    bool lost_ = false;
};

// The master's end, for one node.
class NodeGuard {
  public:
    enum class Heard : std::uint8_t {
        nothing,       // no answer of this node
        state,         // state() is the node's
        wrong_toggle,  // an answer that does not count: the node was reset, or an answer was lost or doubled
        boot_up,       // the next answer has toggle bit 0
    };

    NodeGuard() = default;
    // As above; a guard time of 0 guards nothing.
    NodeGuard(std::uint8_t node_id, Time guard_time, std::uint8_t factor)
        : node_id_(node_id), guard_time_(guard_time), life_time_(guard_time * factor) {}

    // The first question is due now; the first answer may have either toggle bit.
    void start(Time now);
    void stop();

    Heard receive(const frame::Frame& frame, Time now);
    // Asks when it is time. Returns when time alone will make something due.
    Time poll(Time now, frame::FramePort& port);
    bool pending() const { return refused_; }

    NmtState state() const { return state_; }  // of the last answer that counted
    bool lost() const { return lost_; }        // no answer that counts for a life time; until the next one

  private:
    enum class Toggle : std::uint8_t { clear, set, either };

    std::uint8_t node_id_ = 0;
    Time guard_time_ = 0;
    Time life_time_ = 0;
    Time next_question_ = never;
    Time lost_at_ = never;
    NmtState state_ = NmtState::initialising;
    Toggle expected_ = Toggle::either;
    bool refused_ = false;
    bool lost_ = false;
};

}  // namespace cgw::canopen
