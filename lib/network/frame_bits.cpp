#include "network/frame_bits.hpp"

#include <array>
#include <cstddef>

namespace cgw::network {
namespace {

constexpr unsigned identifier_bits = 11;
constexpr unsigned length_bits = 4;
constexpr unsigned checksum_bits = 15;
constexpr unsigned longest_run = 5;  // equal bits after which a stuff bit follows
constexpr unsigned header_bits = 1 + identifier_bits + 3 + length_bits;

// Counts the stuff bits of a row of bits.
class Stuffing {
  public:
    void add(bool bit) {
        run_ = bit == last_ ? run_ + 1 : 1;
        last_ = bit;
        if (run_ == longest_run) {
            ++stuffed_;
            last_ = !bit;
            run_ = 1;
        }
    }
    std::uint32_t stuffed() const { return stuffed_; }

  private:
    bool last_ = true;  // an idle bus is recessive, which the first bit ends
    unsigned run_ = 0;
    std::uint32_t stuffed_ = 0;
};

// CRC of CAN: x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1.
class Checksum {
  public:
    void add(bool bit) {
        constexpr unsigned polynomial = 0x4599;
        const bool carry = ((value_ >> (checksum_bits - 1)) & 1U) != 0;
        value_ = (value_ << 1U) & ((1U << checksum_bits) - 1U);
        value_ ^= bit != carry ? polynomial : 0U;
    }
    unsigned value() const { return value_; }

  private:
    unsigned value_ = 0;
};

// Start of frame, identifier, RTR, IDE and the reserved bit (dominant), length; then the first bit is the
// highest one.
unsigned header(std::uint32_t identifier, unsigned bytes) {
    return (identifier << (3 + length_bits)) | bytes;
}

template <typename Take>
void for_each_bit(unsigned value, unsigned count, Take take) {
    while (count-- != 0) {
        take(((value >> count) & 1U) != 0);
    }
}

// Probabilities of what the last bit was and how many like it came in a row.
using Runs = std::array<std::array<double, longest_run>, 2>;

// One more bit, which is `one` with this probability; returns that of a stuff bit behind it.
double add_bit(Runs& runs, double one) {
    Runs next{};
    double stuffed = 0;
    for (std::size_t last = 0; last < 2; ++last) {
        const double same = last == 1 ? one : 1 - one;
        for (std::size_t run = 1; run < longest_run; ++run) {
            next[1 - last][1] += runs[last][run] * (1 - same);
            if (run + 1 < longest_run) {
                next[last][run + 1] += runs[last][run] * same;
            } else {
                stuffed += runs[last][run] * same;
                next[1 - last][1] += runs[last][run] * same;
            }
        }
    }
    runs = next;
    return stuffed;
}

}  // namespace

std::uint32_t exact_bits(std::uint32_t identifier, std::span<const std::uint8_t> data) {
    Stuffing stuffing;
    Checksum checksum;
    const auto add = [&](bool bit) {
        stuffing.add(bit);
        checksum.add(bit);
    };
    const auto bytes = static_cast<unsigned>(data.size());
    for_each_bit(header(identifier, bytes), header_bits, add);
    for (const std::uint8_t byte : data) {
        for_each_bit(byte, 8, add);
    }
    for_each_bit(checksum.value(), checksum_bits, [&](bool bit) { stuffing.add(bit); });
    return unstuffed_bits(bytes) + stuffing.stuffed();
}

double average_bits(std::uint32_t identifier, unsigned bytes) {
    if (bytes == 0) {
        return exact_bits(identifier, {});
    }
    Runs runs{};
    double stuffed = 0;
    bool first = true;
    for_each_bit(header(identifier, bytes), header_bits, [&](bool bit) {
        if (first) {
            runs[bit ? 1 : 0][1] = 1;
            first = false;
            return;
        }
        stuffed += add_bit(runs, bit ? 1 : 0);
    });
    // A CRC over random data is as random.
    for (unsigned bit = 0; bit < 8 * bytes + checksum_bits; ++bit) {
        stuffed += add_bit(runs, 0.5);
    }
    return unstuffed_bits(bytes) + stuffed;
}

}  // namespace cgw::network
