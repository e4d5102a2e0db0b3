// Text for people: several counted texts as one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/wrap.hpp"

namespace cgw::explain {

inline constexpr std::size_t page_width = 80;  // columns

using base::wrap;

// Texts that differ in numbers only, as one: "word 1 of TPDO4" and "word 4 of TPDO4" give "word 1..4 of
// TPDO4", "1804h:1" and "180Fh:1" give "1804h..180Fh:1". nullopt when they differ in anything else.
std::optional<std::string> merged_text(std::string_view first, std::string_view last);

// `text` with every `from` replaced.
std::string replaced(std::string_view text, std::string_view from, std::string_view to);

}  // namespace cgw::explain
