// One repair: changes of lines that are made together, and what they come to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eds/document.hpp"

namespace cgw::eds_check {

struct Change {
    enum class Kind : std::uint8_t { replace, remove_line, insert_after };
    Kind kind = Kind::replace;
    eds::Span span;  // of the other kinds only its line counts
    std::string text;
};

struct Repair {
    std::string what;  // "SubNumber=5 becomes 4"
    std::vector<Change> changes{};
};

}  // namespace cgw::eds_check
