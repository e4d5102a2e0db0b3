// E09: XDD and XDC, as they are read. Every name once; the rows stand in xdd.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_XDD_RULES(RULE) \
    RULE(xdd_text) \
    RULE(xdd_root) \
    RULE(xdd_absent) \
    RULE(xdd_value) \
    RULE(xdd_number_range) \
    RULE(xdd_number_form) \
    RULE(xdd_data_type) \
    RULE(xdd_object_type) \
    RULE(xdd_access) \
    RULE(xdd_no_access) \
    RULE(xdd_reference) \
    RULE(xdd_contradiction) \
    RULE(xdd_twice) \
    RULE(xdd_no_type) \
    RULE(xdd_bit_rate) \
    RULE(xdd_sub_number) \
    RULE(xdd_sub_object_type) \
    RULE(xdd_information)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_XDD_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
