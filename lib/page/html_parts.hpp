// Inside the page room: the parts of the HTML form.
#pragma once

#include <string>
#include <string_view>

#include "page/page.hpp"

namespace cgw::page {

extern const std::string_view style_sheet;

std::string frame_svg(const Frame& frame);
std::string strip_svg(const Strip& strip);
std::string bar_svg(const Bar& bar, Tone tone);
std::string_view class_of(Tone tone);  // "plain", "good", "warning", "bad"

}  // namespace cgw::page
