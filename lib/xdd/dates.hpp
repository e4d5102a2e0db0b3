// Dates and times as an EDS writes them (mm-dd-yyyy, hh:mmAM) and as XML Schema does (yyyy-mm-dd, hh:mm:ss).
#pragma once

#include <string>
#include <string_view>

namespace cgw::xdd {

// "" for a text of another form, and for no date or time of a day.

std::string xml_date(std::string_view eds_date);
std::string xml_time(std::string_view eds_time);

// Fractions of a second, and the time zone, are passed over. "" for the date that stands for "not known".
std::string eds_date(std::string_view xml_date);
std::string eds_time(std::string_view xml_time);

}  // namespace cgw::xdd
