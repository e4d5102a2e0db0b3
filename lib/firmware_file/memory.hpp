// Bytes at addresses, as a programmer writes them into a device.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.hpp"

namespace cgw::firmware_file {

// Addresses are at most 2^63, so that sums of address and size never wrap.
struct Block {
    std::uint64_t address = 0;
    base::Bytes bytes;

    std::uint64_t end() const { return address + bytes.size(); }
    friend bool operator==(const Block&, const Block&) = default;
};

// Blocks in ascending order that neither overlap nor touch.
class Memory {
  public:
    Memory() = default;
    Memory(std::uint64_t address, std::span<const std::uint8_t> bytes) { put(address, bytes); }

    const std::vector<Block>& blocks() const { return blocks_; }

    // Behind everything that is there; touching bytes join the last block.
    void append(std::uint64_t address, std::span<const std::uint8_t> bytes);

    // Over whatever stands there.
    void put(std::uint64_t address, std::span<const std::uint8_t> bytes);

    // The bytes from an address to the end of its block; empty where none stands.
    std::span<const std::uint8_t> from(std::uint64_t address) const;

    friend bool operator==(const Memory&, const Memory&) = default;

  private:
    std::vector<Block> blocks_;
};

}  // namespace cgw::firmware_file
