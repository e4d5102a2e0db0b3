// E06: scenario files. Every name once; the rows stand in scenarios.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_SCENARIOS_RULES(RULE) \
    RULE(step_action) \
    RULE(step_time) \
    RULE(step_subject) \
    RULE(step_value) \
    RULE(step_answer)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_SCENARIOS_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
