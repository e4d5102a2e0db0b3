#include "wire/crc32.hpp"

namespace cgw::wire {
namespace {

// Sixteen entries, a nibble at a time: 64 bytes of flash instead of a kilobyte.
constexpr std::uint32_t nibble_table[16] = {
    0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
    0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C, 0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        crc = (crc >> 4) ^ nibble_table[crc & 0x0FU];
        crc = (crc >> 4) ^ nibble_table[crc & 0x0FU];
    }
    return ~crc;
}

}  // namespace cgw::wire
