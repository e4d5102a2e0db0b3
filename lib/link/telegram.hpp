// Telegrams of the governor link on CAN1 (D56; docs/governor-link.md): which frame says what, and to whom.
// They are ours, not HEINZMANN's, and 29-bit, so that nobody takes them for anything else.
#pragma once

#include <cstdint>
#include <optional>

#include "frame/frame.hpp"

namespace cgw::link {

// Node numbers on the HEINZMANN CAN bus are unique per type (D4).
enum class DeviceType : std::uint8_t { governor = 1, gateway = 2 };

struct Address {
    DeviceType type = DeviceType::governor;
    std::uint8_t node = 0;  // 1..31

    friend bool operator==(const Address&, const Address&) = default;
};

// In the order of their urgency: a smaller one wins the bus.
enum class Kind : std::uint8_t {
    command = 0x01,            // governor: what the state machine is to do
    status = 0x02,             // gateway: state, errors, what it made of the last command
    refusal = 0x03,            // gateway: why it refused the configuration
    own_errors_first = 0x04,   // gateway: its share of 2000h:1..4
    own_errors_last = 0x05,    // gateway: its share of 2000h:5..6
    process_data = 0x10,       // gateway: + r, the words of RPDO r
    analogue = 0x20,           // governor: + n, the words of TPDO n
    errors_first = 0x38,       // governor: 2000h:1..4
    cycle = 0x39,              // governor: 2000h:5..7; a main cycle is complete
    configuration = 0x40,      // governor: three items of its half of the configuration
    configuration_end = 0x41,  // governor: how many there were
};

struct Telegram {
    std::uint8_t kind = 0;  // of Kind, with the number of a PDO added
    Address from;
    Address to;
    std::uint8_t length = 0;
    const std::uint8_t* data = nullptr;  // in the frame it was read from
};

std::uint32_t identifier(std::uint8_t kind, Address from, Address to);
// Nothing for frames that are none of the link's.
std::optional<Telegram> read_telegram(const frame::Frame& frame);

frame::Frame make_telegram(std::uint8_t kind, Address from, Address to, std::uint8_t length);

constexpr std::uint8_t kind_of(Kind kind, unsigned number = 0) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(kind) + number);
}

}  // namespace cgw::link
