#include "firmware_file/memory.hpp"

#include <algorithm>

namespace cgw::firmware_file {

void Memory::append(std::uint64_t address, std::span<const std::uint8_t> bytes) {
    if (blocks_.empty() || blocks_.back().end() != address) {
        blocks_.push_back({address, {}});
    }
    blocks_.back().bytes.insert(blocks_.back().bytes.end(), bytes.begin(), bytes.end());
}

void Memory::put(std::uint64_t address, std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) {
        return;
    }
    const std::uint64_t end = address + bytes.size();
    std::vector<Block> before;
    std::vector<Block> behind;
    Block joined{address, base::Bytes(bytes.begin(), bytes.end())};
    for (Block& block : blocks_) {
        if (block.end() < address) {
            before.push_back(std::move(block));
            continue;
        }
        if (block.address > end) {
            behind.push_back(std::move(block));
            continue;
        }
        if (block.end() > end) {
            const auto tail = static_cast<std::ptrdiff_t>(end - block.address);
            joined.bytes.insert(joined.bytes.end(), block.bytes.begin() + tail, block.bytes.end());
        }
        if (block.address < address) {
            const auto head = static_cast<std::ptrdiff_t>(address - block.address);
            joined.bytes.insert(joined.bytes.begin(), block.bytes.begin(), block.bytes.begin() + head);
            joined.address = block.address;
        }
    }
    before.push_back(std::move(joined));
    std::move(behind.begin(), behind.end(), std::back_inserter(before));
    blocks_ = std::move(before);
}

std::span<const std::uint8_t> Memory::from(std::uint64_t address) const {
    const auto next =
        std::upper_bound(blocks_.begin(), blocks_.end(), address,
                         [](std::uint64_t wanted, const Block& block) { return wanted < block.address; });
    if (next == blocks_.begin()) {
        return {};
    }
    const Block& block = *std::prev(next);
    return address < block.end() ? std::span(block.bytes).subspan(address - block.address)
                                 : std::span<const std::uint8_t>{};
}

}  // namespace cgw::firmware_file
