#include "link/telegram.hpp"

namespace cgw::link {
namespace {

// Bits 28..24 of every identifier; the kind is in 23..16, sender and receiver below, type before node.
constexpr std::uint32_t mark = 0x15;
constexpr unsigned mark_shift = 24;
constexpr unsigned kind_shift = 16;
constexpr unsigned from_shift = 8;
constexpr unsigned type_shift = 5;
constexpr std::uint32_t node_mask = 0x1F;
constexpr std::uint32_t type_mask = 0x07;
constexpr std::uint32_t byte_mask = 0xFF;

constexpr std::uint32_t address_bits(Address address) {
    return (static_cast<std::uint32_t>(address.type) << type_shift) | (address.node & node_mask);
}

constexpr Address address_of(std::uint32_t bits) {
    return {static_cast<DeviceType>((bits >> type_shift) & type_mask),
            static_cast<std::uint8_t>(bits & node_mask)};
}

}  // namespace

std::uint32_t identifier(std::uint8_t kind, Address from, Address to) {
    return (mark << mark_shift) | (std::uint32_t{kind} << kind_shift) | (address_bits(from) << from_shift) |
           address_bits(to);
}

std::optional<Telegram> read_telegram(const frame::Frame& frame) {
    if (!frame.extended || frame.remote || (frame.id >> mark_shift) != mark) {
        return std::nullopt;
    }
    return Telegram{static_cast<std::uint8_t>(frame.id >> kind_shift),
                    address_of((frame.id >> from_shift) & byte_mask), address_of(frame.id & byte_mask),
                    frame.length, frame.data.data()};
}

frame::Frame make_telegram(std::uint8_t kind, Address from, Address to, std::uint8_t length) {
    frame::Frame frame;
    frame.id = identifier(kind, from, to);
    frame.extended = true;
    frame.length = length;
    return frame;
}

}  // namespace cgw::link
