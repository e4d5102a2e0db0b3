// E01: keys, parameters, values. Every name once; the rows stand in keys.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_KEYS_RULES(RULE) \
    RULE(key_unknown) \
    RULE(key_type) \
    RULE(key_missing) \
    RULE(key_value) \
    RULE(parameter_unknown) \
    RULE(parameter_name_mismatch) \
    RULE(parameter_not_settable) \
    RULE(parameter_duplicate) \
    RULE(parameter_missing) \
    RULE(value_type) \
    RULE(value_range) \
    RULE(list_too_long) \
    RULE(declaration_invalid) \
    RULE(declaration_contradiction) \
    RULE(network_node_duplicate)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_KEYS_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
