// NMT commands on their way: sent in the order they were given, each once, also when they come faster than
// the port takes them.
#pragma once

#include <array>
#include <cstddef>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::master {

class CommandQueue {
  public:
    static constexpr std::size_t capacity = 32;

    // `node_id` 0: all nodes. False when `capacity` commands wait.
    bool add(canopen::NmtCommand command, std::uint8_t node_id);
    // False: the port did not take all of them.
    bool send_pending(frame::FramePort& port);
    bool pending() const { return count_ != 0; }

  private:
    struct Command {
        canopen::NmtCommand command = canopen::NmtCommand::start;
        std::uint8_t node_id = canopen::all_nodes;
    };

    std::array<Command, capacity> waiting_{};  // ring
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace cgw::master
