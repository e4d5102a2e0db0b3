#include "simulation/bus.hpp"

#include <algorithm>

#include "simulation/frame_time.hpp"

namespace cgw::simulation {
namespace {

// Smaller wins: the identifier as it stands on the wire, then data before remote, then 11 before 29 bits.
std::uint64_t priority(const frame::Frame& frame) {
    const std::uint64_t identifier = frame.extended ? frame.id : std::uint64_t{frame.id} << 18;
    return (identifier << 2) | (frame.extended ? 2U : 0U) | (frame.remote ? 1U : 0U);
}

}  // namespace

bool Bus::Node::send(const frame::Frame& frame) {
    const bool taken = take(frame);
    if (watch) {
        watch(frame, taken);
    }
    return taken;
}

bool Bus::Node::take(const frame::Frame& frame) {
    if (!on_line() || queue.size() >= queue_capacity) {
        return false;
    }
    queue.push_back(frame);
    return true;
}

Bus::Bus(unsigned bit_rate_kbit) : bit_time_(1000 / bit_rate_kbit) {}

frame::FramePort& Bus::attach(Participant& participant, std::size_t queue_capacity) {
    nodes_.push_back(std::make_unique<Node>(*this, participant, queue_capacity));
    return *nodes_.back();
}

void Bus::attach_clock(Participant& participant) {
    attach(participant, 0);
}

void Bus::watch_port(const Participant& participant, const PortWatch& watch) {
    for (const std::unique_ptr<Node>& node : nodes_) {
        if (node->participant == &participant) {
            node->watch = watch;
        }
    }
}

void Bus::connect(const Participant& participant, bool connected) {
    for (const std::unique_ptr<Node>& node : nodes_) {
        if (node->participant == &participant) {
            node->connected = connected;
        }
    }
}

void Bus::run_until(Time end) {
    Bus* const self = this;
    run_until({&self, 1}, end);
}

void Bus::run_until(std::span<Bus* const> buses, Time end) {
    while (true) {
        for (Bus* const bus : buses) {
            bus->poll_all();
        }
        Time next = canopen::never;
        for (Bus* const bus : buses) {
            if (bus->sender_ == nullptr) {
                bus->start_frame();
            }
            next = std::min(next, bus->next_event());
        }
        for (Bus* const bus : buses) {
            bus->now_ = std::min(next, end);
        }
        if (next > end) {
            return;
        }
        for (Bus* const bus : buses) {
            if (bus->sender_ != nullptr && bus->now_ == bus->frame_end_) {
                bus->finish_frame();
            }
        }
    }
}

void Bus::poll_all() {
    for (const std::unique_ptr<Node>& node : nodes_) {
        node->deadline = node->participant->poll(now_);
    }
}

// Arbitration: of all the frames offered, the lowest identifier; of equal ones, the node attached first.
void Bus::start_frame() {
    for (const std::unique_ptr<Node>& node : nodes_) {
        if (node->queue.empty() || !node->on_line()) {
            continue;
        }
        if (sender_ == nullptr || priority(node->queue.front()) < priority(sender_->queue.front())) {
            sender_ = node.get();
        }
    }
    if (sender_ != nullptr) {
        on_wire_ = sender_->queue.front();
        sender_->queue.pop_front();
        const Time duration = bits_on_wire(on_wire_) * bit_time_;
        frame_end_ = now_ + duration;
        busy_time_ += duration;
    }
}

void Bus::finish_frame() {
    Node* const sender = sender_;
    sender_ = nullptr;
    if (!sender->on_line()) {
        return;
    }
    ++frames_;
    for (const Observer& observer : observers_) {
        observer(on_wire_, now_);
    }
    for (const std::unique_ptr<Node>& node : nodes_) {
        if (node.get() != sender && node->on_line()) {
            node->participant->receive(on_wire_, now_);
        }
    }
}

Time Bus::next_event() const {
    Time next = sender_ == nullptr ? canopen::never : frame_end_;
    for (const std::unique_ptr<Node>& node : nodes_) {
        next = std::min(next, node->deadline);
    }
    return next;
}

}  // namespace cgw::simulation
