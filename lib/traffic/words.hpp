// Words of CiA 301 for what is on the bus.
#pragma once

#include <cstdint>
#include <string_view>

namespace cgw::traffic {

// "start", "stop", "enter Pre-Operational", "reset node", "reset communication"; "" for no command.
std::string_view nmt_command_text(std::uint8_t command);

// Of a heartbeat's byte: "boot-up", "Stopped", "Operational", "Pre-Operational"; "" for no state.
std::string_view nmt_state_text(std::uint8_t state);

// What an emergency error code says, by its class where it has no row of its own: "CAN-ID collision".
std::string_view emergency_text(std::uint16_t code);

}  // namespace cgw::traffic
