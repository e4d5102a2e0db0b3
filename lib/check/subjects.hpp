// The functions behind the check table, one source file per subject. Each stays silent where a value it
// needs is absent or refused already, so that one mistake gives one finding.
#pragma once

#include "check/checks.hpp"

namespace cgw::check {

// hzm_bus.cpp
void check_hzm_nodes(const Context& context);
void check_hzm_bit_rates(const Context& context);
void check_communication(const Context& context);
void check_start_up_delays(const Context& context);
void check_comparable_bit_rates(const Context& context);

// bit_timing.cpp
void check_possible_timing(const Context& context);
void check_usual_bit_rate(const Context& context);
void check_sample_point(const Context& context);

// nodes.cpp
void check_partner(const Context& context);
void check_listed_nodes(const Context& context);
void check_heartbeat_partner(const Context& context);
void check_partner_unmonitored(const Context& context);
void check_heartbeat(const Context& context);

// identifiers.cpp
void check_reserved_identifiers(const Context& context);
void check_duplicate_identifiers(const Context& context);
void check_foreign_identifiers(const Context& context);
void check_restricted_identifiers(const Context& context);
void check_unlisted_owners(const Context& context);
void check_default_rpdos(const Context& context);

// times.cpp
void check_times(const Context& context);
void check_quantised_times(const Context& context);

// monitoring.cpp
void check_early_monitoring(const Context& context);
void check_short_monitoring(const Context& context);
void check_unmonitored_rpdos(const Context& context);
void check_inactive_monitoring(const Context& context);  // after the checks of inputs.cpp

// inputs.cpp
void check_switch_bits(const Context& context);
void check_sensor_channels(const Context& context);
void check_engine_stop(const Context& context);
void check_switches_without_bit(const Context& context);
void check_sensors_without_channel(const Context& context);
void check_shared_bits(const Context& context);
void check_shared_channels(const Context& context);

// outputs.cpp
void check_known_outputs(const Context& context);
void check_bit_outputs(const Context& context);

// tpdos.cpp
void check_empty_tpdos(const Context& context);
void check_unsent_tpdos(const Context& context);
void check_closed_up_words(const Context& context);

// spelling.cpp
void check_decimal_literals(const Context& context);
void check_misprints(const Context& context);

}  // namespace cgw::check
