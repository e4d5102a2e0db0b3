#include <algorithm>
#include <array>
#include <random>

#include "fuzz/mutation.hpp"

namespace cgw::fuzz {
namespace {

using Random = std::minstd_rand;

// Below `limit`, which is not 0.
std::size_t below(Random& random, std::size_t limit) {
    return random() % limit;
}

// Bytes leave, or come in: those of another place once more, or one byte many times.
std::size_t shift(std::uint8_t* data, std::size_t size, std::size_t limit, Random& random) {
    const std::size_t at = below(random, size + 1);
    const std::size_t count = 1 + below(random, below(random, 4) == 0 ? 64 : 4);
    if (below(random, 2) == 0) {
        const std::size_t gone = std::min(count, size - at);
        std::copy(data + at + gone, data + size, data + at);
        return size - gone;
    }
    const std::size_t more = std::min(count, limit - size);
    std::copy_backward(data + at, data + size, data + size + more);
    const std::size_t from = below(random, size + 1);
    const bool is_copy = size != 0 && below(random, 2) == 0;
    const auto byte = static_cast<std::uint8_t>(random());
    for (std::size_t i = 0; i < more; ++i) {
        data[at + i] = is_copy ? data[(from + i) % size] : byte;
    }
    return size + more;
}

}  // namespace

std::size_t change_bytes(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed) {
    constexpr std::array<std::uint8_t, 8> remarkable = {0x00, 0x01, 0x7F, 0x80, 0xFF, '\n', '0', '"'};
    Random random(seed);
    const std::size_t at = size == 0 ? 0 : below(random, size);
    switch (size == 0 ? 3 : below(random, 4)) {
        case 0:
            data[at] ^= static_cast<std::uint8_t>(1U << below(random, 8));
            return size;
        case 1:
            data[at] = static_cast<std::uint8_t>(random());
            return size;
        case 2:
            data[at] = remarkable[below(random, remarkable.size())];
            return size;
        default:
            return shift(data, size, limit, random);
    }
}

}  // namespace cgw::fuzz
