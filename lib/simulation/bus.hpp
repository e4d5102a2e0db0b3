// A CAN bus inside one process, in simulated microseconds. The same participants give the same frames at the
// same times, byte for byte.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::simulation {

using canopen::Time;

class Participant {
  public:
    // Called at every event on the bus and when its own deadline comes. Returns the next deadline, later than
    // `now`, or never.
    virtual Time poll(Time now) = 0;
    // Frames of the others, at the moment their last bit is over.
    virtual void receive(const frame::Frame& /*frame*/, Time /*now*/) {}

  protected:
    ~Participant() = default;
};

class Bus {
  public:
    Bus(const Bus&) = delete;
    Bus& operator=(const Bus&) = delete;
    ~Bus() = default;

    // Several buses at the same time; a participant may have a transceiver on each.
    static void run_until(std::span<Bus* const> buses, Time end);

    using Observer = std::function<void(const frame::Frame&, Time)>;

    // 125, 250, 500 or 1000 kbit/s, so that a bit lasts whole microseconds.
    explicit Bus(unsigned bit_rate_kbit);

    // A transceiver for `participant`; its port says "not now" while `queue_capacity` frames wait. A node's
    // frames leave in the order they were sent; between nodes the lowest identifier wins.
    frame::FramePort& attach(Participant& participant, std::size_t queue_capacity = 16);
    // Something that only needs the clock.
    void attach_clock(Participant& participant);
    // Cuts or mends the whole bus, or one participant's cable. Who is cut off is told "not now"; its waiting
    // frames stay, and a frame that is on the wire is lost for who is not connected when it is over.
    void connect(bool connected) { connected_ = connected; }
    void connect(const Participant& participant, bool connected);
    bool connected() const { return connected_; }

    // Every frame, when it is over; observers are called in the order they came.
    void observe(Observer observer) { observers_.push_back(std::move(observer)); }

    // Every frame that a participant offers to its port, and whether the port took it.
    using PortWatch = std::function<void(const frame::Frame&, bool taken)>;
    void watch_port(const Participant& participant, const PortWatch& watch);

    // Runs through everything that happens up to and including `end`.
    void run_until(Time end);

    Time now() const { return now_; }
    // When something happens next: a frame is over, or a participant's deadline comes.
    Time next_event() const;
    std::uint64_t frames() const { return frames_; }
    Time busy_time() const { return busy_time_; }  // microseconds with a frame on the bus

  private:
    struct Node final : frame::FramePort {
        Node(const Bus& on, Participant& who, std::size_t capacity)
            : bus(&on), participant(&who), queue_capacity(capacity) {}
        bool send(const frame::Frame& frame) override;
        bool take(const frame::Frame& frame);
        bool on_line() const { return connected && bus->connected_; }

        const Bus* bus;
        Participant* participant;
        std::size_t queue_capacity;
        bool connected = true;
        std::deque<frame::Frame> queue;
        PortWatch watch;
        Time deadline = 0;
    };

    void poll_all();
    void start_frame();
    void finish_frame();
    Time bit_time_;  // microseconds
    bool connected_ = true;
    Time now_ = 0;
    std::vector<std::unique_ptr<Node>> nodes_;
    std::vector<Observer> observers_;
    Node* sender_ = nullptr;
    frame::Frame on_wire_;
    Time frame_end_ = 0;
    std::uint64_t frames_ = 0;
    Time busy_time_ = 0;
};

}  // namespace cgw::simulation
