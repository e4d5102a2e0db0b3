#include "check/checks.hpp"

#include "check/subjects.hpp"

namespace cgw::check {

namespace {

namespace rules = diagnostic::rules;

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
