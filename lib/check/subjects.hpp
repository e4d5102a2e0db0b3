// The functions behind the check table, one source file per subject. Each stays silent where a value it
// needs is absent or refused already, so that one mistake gives one finding.
#pragma once

#include "check/checks.hpp"

namespace cgw::check {

// hzm_bus.cpp
void check_hzm_nodes(const Context& context);
void check_hzm_bit_rates(const Context& context);
void check_communication(const Context& context);

// nodes.cpp
void check_partner(const Context& context);
void check_listed_nodes(const Context& context);
void check_heartbeat_partner(const Context& context);

// identifiers.cpp
void check_reserved_identifiers(const Context& context);
void check_duplicate_identifiers(const Context& context);
void check_foreign_identifiers(const Context& context);

// times.cpp
void check_times(const Context& context);

// inputs.cpp
void check_switch_bits(const Context& context);
void check_sensor_channels(const Context& context);
void check_engine_stop(const Context& context);

// outputs.cpp
void check_known_outputs(const Context& context);
void check_bit_outputs(const Context& context);

}  // namespace cgw::check
