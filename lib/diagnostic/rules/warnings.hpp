// E03: warnings, what works but hardly as it was meant. Every name once; the rows stand in warnings.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_WARNINGS_RULES(RULE) \
    RULE(monitoring_early) \
    RULE(monitoring_short) \
    RULE(rpdo_unmonitored) \
    RULE(rpdo_inactive_monitored) \
    RULE(decimal_for_hexadecimal) \
    RULE(cob_id_restricted) \
    RULE(tpdo_empty) \
    RULE(tpdo_unsent) \
    RULE(switch_without_bit) \
    RULE(sensor_without_channel) \
    RULE(switch_bit_shared) \
    RULE(sensor_channel_shared) \
    RULE(start_up_delay_mismatch) \
    RULE(partner_unmonitored) \
    RULE(heartbeat_off) \
    RULE(bit_rate_unusual) \
    RULE(sample_point)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_WARNINGS_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
