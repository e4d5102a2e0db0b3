// Words and numbers that reader and writer share.
#pragma once

#include <array>

#include "dictionary/words.hpp"

namespace cgw::eds {

using dictionary::access_types;

// BaudRate_…, kbit/s.
inline constexpr std::array<unsigned, 8> bit_rate_keys{10, 20, 50, 125, 250, 500, 800, 1000};

}  // namespace cgw::eds
