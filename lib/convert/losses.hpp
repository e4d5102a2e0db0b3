// What of a description a format has no place for: a table, from which the list in docs/conversions.md is
// made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "convert/description.hpp"

namespace cgw::convert {

enum class Medium : std::uint8_t { eds, dcf, xdd, xdc, markdown, csv };
inline constexpr std::size_t media = 6;

// Several of them: bit n is medium n.
using Media = std::uint8_t;
constexpr Media in(Medium medium) {
    return static_cast<Media>(1U << static_cast<unsigned>(medium));
}

struct LossRow {
    std::string_view text;  // "links between objects (ObjectLinks)"
    Media lost_in;
    std::size_t (*lose)(Description& description);  // takes it away; how often it was there

    bool is_lost_in(Medium medium) const { return (lost_in & in(medium)) != 0; }
};

std::span<const LossRow> loss_rows();

struct Loss {
    const LossRow* row = nullptr;
    std::size_t count = 0;  // 1..
};

// Takes away what the medium cannot hold. What is left is what reads back from a file, where it is one to be
// read back, and what the table shows.
std::vector<Loss> lose(Description& description, Medium medium);

// The rows as a table of Markdown.
std::string losses_markdown();

}  // namespace cgw::convert
