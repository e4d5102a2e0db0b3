// A CAN database (DBC) as data: messages, signals, cycle times, value tables. What this program makes no use
// of (environment variables, signal groups, other attributes) is passed over.
#pragma once

#include <string>
#include <string_view>

#include "dbc/database.hpp"
#include "diagnostic/diagnostic.hpp"

namespace cgw::dbc {

inline constexpr std::size_t largest_text = 32U * 1024U * 1024U;  // bytes

// What cannot be read is a finding (E10) at its place and is left out; the rest is read all the same. `path`
// as the findings are to name the file.
Database read(std::string_view text, const std::string& path, diagnostic::Findings& findings);

}  // namespace cgw::dbc
