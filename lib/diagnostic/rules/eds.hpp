// E08: EDS and DCF, as they are read. Every name once; the rows stand in the files eds_*.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_EDS_RULES(RULE) \
    RULE(eds_text) \
    RULE(eds_line) \
    RULE(eds_header) \
    RULE(eds_section_twice) \
    RULE(eds_key_twice) \
    RULE(eds_value) \
    RULE(eds_number_range) \
    RULE(eds_number_form) \
    RULE(eds_formula) \
    RULE(eds_access_type) \
    RULE(eds_data_type) \
    RULE(eds_object_type) \
    RULE(eds_key_absent) \
    RULE(eds_section_alone) \
    RULE(eds_entry_alone) \
    RULE(eds_spelling) \
    RULE(eds_too_much)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_EDS_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
