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

enum class Medium : std::uint8_t { eds, dcf, xdd, xdc };
inline constexpr std::size_t media = 4;

struct LossRow {
    std::string_view text;  // "links between objects (ObjectLinks)"
    std::span<const Medium> lost_in;
    std::size_t (*lose)(Description& description);  // takes it away; how often it was there
};

std::span<const LossRow> loss_rows();

struct Loss {
    const LossRow* row = nullptr;
    std::size_t count = 0;  // 1..
};

// Takes away what the medium cannot hold. What is left is what reads back from a file.
std::vector<Loss> lose(Description& description, Medium medium);

// The rows as a table of Markdown.
std::string losses_markdown();

}  // namespace cgw::convert
