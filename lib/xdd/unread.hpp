// What of a file cgw passes over, so that no conversion carries it.
#pragma once

#include <cstddef>
#include <string>

namespace cgw::xdd {

struct Unread {
    std::string what;       // "element description", "[Tools]"
    std::size_t count = 0;  // 1..
};

}  // namespace cgw::xdd
