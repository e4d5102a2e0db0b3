// Text for people in lines of a given width.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cgw::base {

// Lines of at most `width` columns, broken at blanks; a longer word has a line of its own. At least one line.
std::vector<std::string> wrap(std::string_view text, std::size_t width);

}  // namespace cgw::base
