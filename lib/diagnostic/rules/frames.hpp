// E12: frames and their values, typed in and recorded. Every name once; the rows stand in frames.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_FRAMES_RULES(RULE) \
    RULE(frame_unknown) \
    RULE(signal_unknown) \
    RULE(signal_value) \
    RULE(signal_range) \
    RULE(signal_twice) \
    RULE(frame_text) \
    RULE(log_record) \
    RULE(log_time) \
    RULE(log_empty) \
    RULE(frame_length) \
    RULE(frame_long) \
    RULE(frame_missing) \
    RULE(frame_not_seen) \
    RULE(frame_unexpected) \
    RULE(frame_period) \
    RULE(frame_gap) \
    RULE(monitoring_exceeded) \
    RULE(frame_when_stopped)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_FRAMES_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
