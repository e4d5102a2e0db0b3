// E10: CAN databases (DBC). Every name once; the rows stand in dbc.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_DBC_RULES(RULE) \
    RULE(dbc_text) \
    RULE(dbc_statement) \
    RULE(dbc_twice)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_DBC_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
