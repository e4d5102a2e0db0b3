// Where something stands in a text file.
#pragma once

#include <cstdint>
#include <string>

namespace cgw::diagnostic {

// 1-based; columns count UTF-8 bytes. {0, 0} means "the file as a whole".
struct Position {
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    friend auto operator<=>(const Position&, const Position&) = default;
};

// The end is exclusive.
struct Range {
    Position start;
    Position end;

    friend auto operator<=>(const Range&, const Range&) = default;
};

struct Location {
    std::string path;  // as the user gave it; "-" is standard input
    Range range;

    friend auto operator<=>(const Location&, const Location&) = default;
};

}  // namespace cgw::diagnostic
