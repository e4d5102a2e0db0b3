// Numbers and formulas as EDS files write them.
#pragma once

#include <cstdint>
#include <string_view>

namespace cgw::eds {

// CiA 306 has decimal numbers, 0x… for hexadecimal, a leading 0 for octal, and the formula $NODEID+number.
struct Number {
    enum class Reading : std::uint8_t {
        number,
        too_large,  // beyond 64 bits
        none,       // no number at all
    };
    Reading reading = Reading::none;
    bool negative = false;
    bool node_id_relative = false;
    bool loose = false;      // readable, and no number of CiA 306: 0x0x12, 0x12LL, +5
    bool misplaced = false;  // a formula, and not written as $NODEID+number: other order, case, blanks
    std::uint64_t magnitude = 0;
};

// `text` without blanks around it; the empty text is no number.
Number parse_number(std::string_view text);

}  // namespace cgw::eds
