// SDO abort codes (CiA 301), with what they mean when the Gateway answers with them (manual 5.2, table 3).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cgw::base {

struct AbortCodeRow {
    std::uint32_t code = 0;
    std::string_view meaning{};  // in general
    std::string_view gateway{};  // when the Gateway sends it; "": it does not
    std::string_view action{};   // what to do then; "" where the Gateway does not send it
    std::string_view brief{};    // the meaning in three or four words; "": `meaning` is short enough
};

// Ascending.
std::span<const AbortCodeRow> abort_codes();
const AbortCodeRow* find_abort_code(std::uint32_t code);  // nullptr: CiA 301 has none of that number

// "abort 0x06010002, read-only object"; the number alone where CiA 301 has none of that number.
std::string abort_text(std::uint32_t code);

}  // namespace cgw::base
