// E04: notes, what the devices make of a setting. Every name once; the rows stand in notes.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_NOTES_RULES(RULE) \
    RULE(manual_misprint) \
    RULE(time_quantised) \
    RULE(tpdo_words_moved) \
    RULE(cob_id_unlisted_owner) \
    RULE(cob_id_default_rpdo) \
    RULE(hzm_bit_rate_unverified)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_NOTES_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
