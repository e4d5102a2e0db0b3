// How many random streams a fuzz test tries: as many as it wants, or CGW_FUZZ_SEEDS for a long run.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>

namespace cgw::media::test {

inline std::uint32_t fuzz_seeds(std::uint32_t usual) {
    const char* wanted = std::getenv("CGW_FUZZ_SEEDS");
    return wanted == nullptr ? usual : static_cast<std::uint32_t>(std::stoul(wanted));
}

}  // namespace cgw::media::test
