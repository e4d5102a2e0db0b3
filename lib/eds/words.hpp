// Words and numbers that reader and writer share.
#pragma once

#include <array>
#include <string_view>

#include "object/vocabulary.hpp"

namespace cgw::eds {

// Spelling of object::Access, in the order of its values.
inline constexpr std::array<std::string_view, 6> access_types{"ro", "wo", "rw", "rwr", "rww", "const"};

// BaudRate_…, kbit/s.
inline constexpr std::array<unsigned, 8> bit_rate_keys{10, 20, 50, 125, 250, 500, 800, 1000};

}  // namespace cgw::eds
