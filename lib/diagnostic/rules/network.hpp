// E11: the load of a CANopen bus. Every name once; the rows stand in network.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_NETWORK_RULES(RULE) \
    RULE(identifier_conflict) \
    RULE(bit_rates_differ) \
    RULE(bus_bit_rate_unknown) \
    RULE(node_shared) \
    RULE(message_unbounded) \
    RULE(deadline_missed) \
    RULE(bus_overloaded) \
    RULE(bus_load_high) \
    RULE(message_late) \
    RULE(message_too_short) \
    RULE(message_not_counted) \
    RULE(message_too_slow) \
    RULE(message_told_twice) \
    RULE(bit_rate_not_offered)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_NETWORK_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
