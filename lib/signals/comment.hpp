// What a signal is, in the words of comments: of CAN databases, generated code and lists.
#pragma once

#include <string>

#include "signals/frames.hpp"

namespace cgw::signals {

// "2000 Speed, 2001h:1"; of a bit also what 1 means. UTF-8, one line unless a name has a line end; no
// scaling.
std::string comment_of(const Signal& signal);

}  // namespace cgw::signals
