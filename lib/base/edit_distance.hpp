// "did you mean": the nearest known name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cgw::base {

// Number of single-character insertions, deletions, substitutions and neighbour swaps, ignoring ASCII case.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `name`, or empty when none is near enough to be helpful (distance over a
// third of the longer name's length). Ties go to the earlier candidate.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace cgw::base
