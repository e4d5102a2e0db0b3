// Dates and times of [FileInfo]: mm-dd-yyyy, and hh:mmAM or hh:mmPM of twelve hours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cgw::eds_check {

bool is_date(std::string_view text);
bool is_time(std::string_view text);

// The same in the form of CiA 306, where it can be meant in one way only: 05-Jan-2004 for a date; 9:05AM,
// 00:00AM, 13:05 and 13:05PM for a time.
std::optional<std::string> as_date(std::string_view text);
std::optional<std::string> as_time(std::string_view text);

}  // namespace cgw::eds_check
