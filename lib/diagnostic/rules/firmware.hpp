// E07: firmware files, and images in them. Every name once; the rows stand in firmware.cpp.
#pragma once

#include "diagnostic/rule.hpp"

// clang-format off
#define CGW_FIRMWARE_RULES(RULE) \
    RULE(firmware_kind) \
    RULE(record_line) \
    RULE(record_checksum) \
    RULE(record_address) \
    RULE(record_end) \
    RULE(elf_structure) \
    RULE(firmware_section) \
    RULE(firmware_address) \
    RULE(image_alignment) \
    RULE(image_room) \
    RULE(image_occupied) \
    RULE(image_refused) \
    RULE(image_model) \
    RULE(image_elsewhere)
// clang-format on

namespace cgw::diagnostic::rules {

CGW_FIRMWARE_RULES(CGW_DECLARE_RULE)

}  // namespace cgw::diagnostic::rules
