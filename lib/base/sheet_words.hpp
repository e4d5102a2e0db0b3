// What an entry sheet says besides its rows: in these words it is written and read back.
#pragma once

#include <string_view>

namespace cgw::base {

inline constexpr std::string_view sheet_heading = "Entry sheet: ";  // the title follows
inline constexpr std::string_view sheet_main_cycle =
    "Main cycle of the governor: ";  // microseconds follow, then " us"

// Columns of the CSV.
inline constexpr std::string_view sheet_title_column = "title";
inline constexpr std::string_view sheet_main_cycle_column = "main_cycle_us";

}  // namespace cgw::base
