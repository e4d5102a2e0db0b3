#include "check/checks.hpp"

#include "check/subjects.hpp"
#include "diagnostic/rules/notes.hpp"
#include "diagnostic/rules/plant.hpp"
#include "diagnostic/rules/warnings.hpp"

namespace cgw::check {

namespace {

namespace rules = diagnostic::rules;

// Errors first: warnings and notes stay silent about a value that an error covers.
const Check table[] = {
    {&rules::hzm_node_mismatch, check_hzm_nodes},
    {&rules::hzm_bit_rate_mismatch, check_hzm_bit_rates},
    {&rules::node_id_duplicate, check_partner},
    {&rules::node_id_listed, check_listed_nodes},
    {&rules::cob_id_reserved, check_reserved_identifiers},
    {&rules::cob_id_duplicate, check_duplicate_identifiers},
    {&rules::cob_id_foreign, check_foreign_identifiers},
    {&rules::heartbeat_partner_missing, check_heartbeat_partner},
    {&rules::time_too_long, check_times},
    {&rules::switch_bit_range, check_switch_bits},
    {&rules::sensor_channel_range, check_sensor_channels},
    {&rules::engine_stop_over_canopen, check_engine_stop},
    {&rules::tpdo_parameter_unknown, check_known_outputs},
    {&rules::tpdo_parameter_bit, check_bit_outputs},
    {&rules::communication_off, check_communication},
    {&rules::bit_timing_impossible, check_possible_timing},

    {&rules::monitoring_early, check_early_monitoring},
    {&rules::monitoring_short, check_short_monitoring},
    {&rules::rpdo_unmonitored, check_unmonitored_rpdos},
    {&rules::decimal_for_hexadecimal, check_decimal_literals},
    {&rules::cob_id_restricted, check_restricted_identifiers},
    {&rules::tpdo_empty, check_empty_tpdos},
    {&rules::tpdo_unsent, check_unsent_tpdos},
    {&rules::switch_without_bit, check_switches_without_bit},
    {&rules::sensor_without_channel, check_sensors_without_channel},
    {&rules::switch_bit_shared, check_shared_bits},
    {&rules::sensor_channel_shared, check_shared_channels},
    {&rules::rpdo_inactive_monitored, check_inactive_monitoring},
    {&rules::start_up_delay_mismatch, check_start_up_delays},
    {&rules::partner_unmonitored, check_partner_unmonitored},
    {&rules::heartbeat_off, check_heartbeat},
    {&rules::bit_rate_unusual, check_usual_bit_rate},
    {&rules::sample_point, check_sample_point},

    {&rules::manual_misprint, check_misprints},
    {&rules::time_quantised, check_quantised_times},
    {&rules::tpdo_words_moved, check_closed_up_words},
    {&rules::cob_id_unlisted_owner, check_unlisted_owners},
    {&rules::cob_id_default_rpdo, check_default_rpdos},
    {&rules::hzm_bit_rate_unverified, check_comparable_bit_rates},
};

}  // namespace

std::span<const Check> all_checks() {
    return table;
}

void check(const Context& context) {
    for (const Check& row : table) {
        row.run(context);
    }
}

}  // namespace cgw::check
