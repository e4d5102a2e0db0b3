// NMT commands and states in words, for people and for scripts; the core itself has no text.
#pragma once

#include <array>
#include <string_view>

#include "canopen/protocol.hpp"

namespace cgw::canopen {

struct NmtCommandWords {
    NmtCommand command;
    std::string_view text;  // "reset node"
    std::string_view word;  // as it is typed: "reset-node"
};

inline constexpr std::array nmt_commands{
    NmtCommandWords{NmtCommand::start, "start", "start"},
    NmtCommandWords{NmtCommand::stop, "stop", "stop"},
    NmtCommandWords{NmtCommand::enter_pre_operational, "enter Pre-Operational", "pre-operational"},
    NmtCommandWords{NmtCommand::reset_node, "reset node", "reset-node"},
    NmtCommandWords{NmtCommand::reset_communication, "reset communication", "reset-communication"},
};

struct NmtStateText {
    NmtState state;
    std::string_view text;
};

inline constexpr std::array nmt_states{
    NmtStateText{NmtState::initialising, "boot-up"},
    NmtStateText{NmtState::stopped, "Stopped"},
    NmtStateText{NmtState::operational, "Operational"},
    NmtStateText{NmtState::pre_operational, "Pre-Operational"},
};

}  // namespace cgw::canopen
