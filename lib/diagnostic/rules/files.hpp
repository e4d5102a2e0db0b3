// E00: files and TOML. Every name once; the rows stand in files.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_FILES_RULES(RULE) \
    RULE(file_unreadable) \
    RULE(file_too_large) \
    RULE(file_not_utf8) \
    RULE(toml_syntax) \
    RULE(toml_number_range) \
    RULE(toml_nesting) \
    RULE(format_missing) \
    RULE(format_unsupported) \
    RULE(catalogue_unreadable)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_FILES_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
