// E05: printed tables read in, files copied. Every name once; the rows stand in tables.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_TABLES_RULES(RULE) \
    RULE(table_row) \
    RULE(table_value_ambiguous) \
    RULE(table_ellipsis) \
    RULE(table_unit) \
    RULE(table_of_other_device) \
    RULE(table_empty) \
    RULE(table_row_skipped) \
    RULE(clone_identifier) \
    RULE(table_row_absent)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_TABLES_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
