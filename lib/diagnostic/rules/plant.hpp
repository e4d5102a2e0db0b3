// E02: what makes the plant fail. Every name once; the rows stand in plant.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_PLANT_RULES(RULE) \
    RULE(hzm_node_mismatch) \
    RULE(hzm_bit_rate_mismatch) \
    RULE(node_id_duplicate) \
    RULE(node_id_listed) \
    RULE(cob_id_reserved) \
    RULE(cob_id_duplicate) \
    RULE(cob_id_foreign) \
    RULE(heartbeat_partner_missing) \
    RULE(time_too_long) \
    RULE(switch_bit_range) \
    RULE(sensor_channel_range) \
    RULE(engine_stop_over_canopen) \
    RULE(tpdo_parameter_unknown) \
    RULE(tpdo_parameter_bit) \
    RULE(communication_off) \
    RULE(bit_timing_impossible)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_PLANT_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
