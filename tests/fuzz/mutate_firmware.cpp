#include <optional>
#include <span>

#include "fuzz/mutation.hpp"

namespace cgw::fuzz {
namespace {

constexpr char digits[] = "0123456789ABCDEF";

std::optional<unsigned> value_of(std::uint8_t digit) {
    if (digit >= '0' && digit <= '9') {
        return digit - '0';
    }
    const unsigned letter = digit & ~0x20U;
    return letter >= 'A' && letter <= 'F' ? std::optional(letter - 'A' + 10U) : std::nullopt;
}

// The record's last byte makes the sum of all 0 (Intel HEX) or 255 (S-record).
void repair(std::span<std::uint8_t> line) {
    const std::size_t begin = !line.empty() && line[0] == ':' ? 1 : 2;
    if (line.size() < begin + 4 || (line.size() - begin) % 2 != 0 || (begin == 2 && line[0] != 'S')) {
        return;
    }
    unsigned sum = 0;
    for (std::size_t i = begin; i + 2 < line.size(); i += 2) {
        const auto high = value_of(line[i]);
        const auto low = value_of(line[i + 1]);
        if (!high || !low) {
            return;
        }
        sum += 16 * *high + *low;
    }
    const unsigned check = (begin == 1 ? 0U - sum : 255U - sum) & 0xFFU;
    line[line.size() - 2] = static_cast<std::uint8_t>(digits[check / 16]);
    line[line.size() - 1] = static_cast<std::uint8_t>(digits[check % 16]);
}

}  // namespace

std::size_t mutate_firmware(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed) {
    const std::size_t changed = change_bytes(data, size, limit, seed);
    if (seed % 4 != 0 && changed != 0 && (data[0] == ':' || data[0] == 'S')) {
        std::size_t begin = 0;
        for (std::size_t at = 0; at <= changed; ++at) {
            if (at == changed || data[at] == '\n' || data[at] == '\r') {
                repair({data + begin, at - begin});
                begin = at + 1;
            }
        }
    }
    return changed;
}

}  // namespace cgw::fuzz
