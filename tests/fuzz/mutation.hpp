// How inputs are changed so that the change gets past the first check: bytes at random alone would only ever
// show that checksums work. Each takes `size` bytes in `data`, which has room for `limit`, and returns how
// many they are then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t limit);

namespace cgw::fuzz {

using Mutation = std::size_t (*)(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);

// Sections change their contents and lengths; sizes, configuration id and CRC-32 are made to fit again.
std::size_t mutate_image(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);
// Lines of Intel HEX and S-record files get right checksums.
std::size_t mutate_firmware(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);
// Words of the tables take the place of others, lines are moved, doubled and left out.
std::size_t mutate_text(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed);

}  // namespace cgw::fuzz
