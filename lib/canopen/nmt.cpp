#include "canopen/nmt.hpp"

#include <array>

#include "wire/search.hpp"

namespace cgw::canopen {
namespace {

constexpr std::array commands = {NmtCommand::start, NmtCommand::stop, NmtCommand::enter_pre_operational,
                                 NmtCommand::reset_node, NmtCommand::reset_communication};
constexpr std::array states = {NmtState::initialising, NmtState::stopped, NmtState::operational,
                               NmtState::pre_operational};

}  // namespace

frame::Frame nmt_frame(NmtCommand command, std::uint8_t node_id) {
    frame::Frame frame;
    frame.id = cob::nmt;
    frame.length = 2;
    frame.data[0] = static_cast<std::uint8_t>(command);
    frame.data[1] = node_id;
    return frame;
}

std::optional<NmtCommand> nmt_command(const frame::Frame& frame, std::uint8_t node_id) {
    if (frame.id != cob::nmt || frame.extended || frame.remote || frame.length != 2) {
        return std::nullopt;
    }
    if (frame.data[1] != node_id && frame.data[1] != all_nodes) {
        return std::nullopt;
    }
    const auto command = static_cast<NmtCommand>(frame.data[0]);
    if (!wire::contains(commands, command)) {
        return std::nullopt;
    }
    return command;
}

std::optional<NmtState> heartbeat_state(const frame::Frame& frame) {
    const auto state = static_cast<NmtState>(frame.data[0]);
    if (frame.extended || frame.remote || frame.length != 1 || !wire::contains(states, state)) {
        return std::nullopt;
    }
    return state;
}

frame::Frame heartbeat_frame(std::uint8_t node_id, NmtState state) {
    frame::Frame frame;
    frame.id = cob::heartbeat + node_id;
    frame.length = 1;
    frame.data[0] = static_cast<std::uint8_t>(state);
    return frame;
}

}  // namespace cgw::canopen
