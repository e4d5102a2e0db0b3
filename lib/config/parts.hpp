// The parts resolve() is made of, one source file each.
#pragma once

#include "config/configuration.hpp"

namespace cgw::config {

// timing.cpp: both CAN buses, start-up delays and heartbeats.
void resolve_buses(const parameter::Settings& settings, Configuration& configuration);
void resolve_heartbeats(const parameter::Settings& settings, Configuration& configuration);

// A time becomes whole main cycles; a decision is noted where that changes it (D8).
CyclicTime resolve_time(const parameter::Settings& settings, parameter::Device device, std::uint16_t number,
                        std::uint32_t main_cycle_us, std::uint8_t pdo, Configuration& configuration);

// transmit_pdos.cpp, receive_pdos.cpp: need the node id and the main cycle.
void resolve_transmit_pdos(const parameter::Settings& settings, const parameter::Catalogue& catalogue,
                           Configuration& configuration);
void resolve_receive_pdos(const parameter::Settings& settings, Configuration& configuration);

// base + node id, or 0 while the node id is not known.
std::uint16_t predefined_identifier(std::uint16_t base, std::uint8_t node_id);

}  // namespace cgw::config
