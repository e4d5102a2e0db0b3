// A half whose names and texts are what nobody should write.
#pragma once

#include <cstdint>

#include "partner/half.hpp"

namespace cgw::test {

// The frames of `half` with names that are words of some language, texts that end comments and strings, units
// of any bytes; words signed and unsigned, on rising and falling lines; another mixture for each seed. Names
// keep to what lib/signals says of them.
partner::Half hostile(partner::Half half, std::uint32_t seed);

}  // namespace cgw::test
