// Inside the room scenario: the keys `min` and `max` of an expectation.
#pragma once

#include <string>
#include <string_view>

#include "scenario/scenario.hpp"

namespace cgw::scenario {

// "at least 3", "3..5", with the unit.
std::string range_text(const Step& step, std::string_view unit);
bool in_range(const Step& step, double value);

}  // namespace cgw::scenario
