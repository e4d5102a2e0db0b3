#include "simulation/frame_time.hpp"

#include <array>
#include <cstdint>

namespace cgw::simulation {
namespace {

constexpr std::uint32_t crc_polynomial = 0x4599;
constexpr unsigned crc_bits = 15;
constexpr unsigned run_before_stuffing = 5;
// CRC delimiter, acknowledge slot and delimiter, seven bits end of frame, three bits interframe space.
constexpr unsigned unstuffed_tail = 1 + 2 + 7 + 3;

// Start of frame to the end of the CRC; counts the stuff bits as the bits come.
class Stuffer {
  public:
    void put(std::uint32_t value, unsigned width) {
        for (unsigned bit = width; bit-- > 0;) {
            put_bit((value >> bit) & 1U);
        }
    }
    void put_crc() { put(crc_, crc_bits); }
    unsigned bits() const { return bits_; }

  private:
    void put_bit(std::uint32_t bit) {
        const bool feedback = ((crc_ >> (crc_bits - 1)) & 1U) != bit;
        crc_ = (crc_ << 1) & ((1U << crc_bits) - 1);
        if (feedback) {
            crc_ ^= crc_polynomial;
        }
        count(bit);
    }
    void count(std::uint32_t bit) {
        run_ = bit == last_ ? run_ + 1 : 1;
        last_ = bit;
        ++bits_;
        if (run_ == run_before_stuffing) {
            ++bits_;
            last_ = bit ^ 1U;
            run_ = 1;
        }
    }

    std::uint32_t crc_ = 0;
    std::uint32_t last_ = 1;  // the bus is recessive before
    unsigned run_ = 0;
    unsigned bits_ = 0;
};

void put_header(const frame::Frame& frame, Stuffer& stuffer) {
    const std::uint32_t remote = frame.remote ? 1 : 0;
    stuffer.put(0, 1);  // start of frame
    if (frame.extended) {
        stuffer.put(frame.id >> 18, 11);
        stuffer.put(0x3, 2);  // substitute remote request, identifier extension
        stuffer.put(frame.id & 0x3FFFF, 18);
        stuffer.put(remote, 1);
        stuffer.put(0, 2);
    } else {
        stuffer.put(frame.id, 11);
        stuffer.put(remote, 1);
        stuffer.put(0, 2);
    }
    stuffer.put(frame.length, 4);
}

}  // namespace

unsigned bits_on_wire(const frame::Frame& frame) {
    Stuffer stuffer;
    put_header(frame, stuffer);
    for (std::size_t i = 0; i < frame.length && !frame.remote; ++i) {
        stuffer.put(frame.data[i], 8);
    }
    stuffer.put_crc();
    return stuffer.bits() + unstuffed_tail;
}

}  // namespace cgw::simulation
