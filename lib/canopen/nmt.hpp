// NMT frames: building and reading them.
#pragma once

#include <optional>

#include "canopen/protocol.hpp"
#include "frame/frame.hpp"

namespace cgw::canopen {

frame::Frame nmt_frame(NmtCommand command, std::uint8_t node_id);

// The command a frame holds for `node_id`, by name or by broadcast. Nothing for another node, another
// length than 2, an unknown command, a remote or extended frame (D58).
std::optional<NmtCommand> nmt_command(const frame::Frame& frame, std::uint8_t node_id);

// The state a heartbeat or boot-up message carries. Nothing for another length than 1, an unknown state, a
// remote or extended frame (D58). The identifier is the caller's to look at.
std::optional<NmtState> heartbeat_state(const frame::Frame& frame);

// A heartbeat, or the boot-up message when `state` is initialising.
frame::Frame heartbeat_frame(std::uint8_t node_id, NmtState state);

}  // namespace cgw::canopen
