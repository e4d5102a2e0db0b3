// What the bytes of the link's telegrams mean, for both ends (docs/governor-link.md).
#pragma once

#include <cstddef>
#include <cstdint>

#include "canopen/protocol.hpp"
#include "device/gateway.hpp"

namespace cgw::link {

using canopen::Time;

// Each end tells of itself at least so often, and counts as silent after `silence` (D46).
inline constexpr Time status_period = 100'000;  // us
inline constexpr Time silence = device::Gateway::governor_silence;
inline constexpr unsigned attempts = 3;  // of an initialisation, before 12412

// Of 2000h:1..6 the first ones travel in one telegram, the last two in another.
inline constexpr std::size_t words_in_first_errors = 4;

namespace command {  // sequence, GovernorCommand, flags, boot number
inline constexpr std::uint8_t length = 4;
inline constexpr std::uint8_t gateway_was_reset = 0x01;  // 12419
inline constexpr std::uint8_t given_up = 0x02;           // 12412
}  // namespace command

namespace cycle {  // 2000h:5, 2000h:6, engine state, flags, boot number, clearings
inline constexpr std::uint8_t length = 8;
inline constexpr std::uint8_t can_bus_error = 0x01;   // the governor's own 3070: 12414
inline constexpr std::uint8_t can_comm_error = 0x02;  // its 3071: 12415
// Above them the main cycles of the governor are counted, those included whose data were not sent.
inline constexpr unsigned count_shift = 2;
inline constexpr std::uint8_t count_mask = 0x3F;
}  // namespace cycle

namespace status {  // state, 2005h, late RPDOs and clearings, flags and entries, boot number, sequence,
                    // Answer
inline constexpr std::uint8_t length = 8;
inline constexpr std::uint8_t late_rpdos_mask = 0x0F;
inline constexpr unsigned clearings_shift = 4;  // "clear errors" at the gateway, counted
inline constexpr std::uint8_t heartbeat_lost = 0x01;
inline constexpr unsigned entries_shift = 1;  // entries into Operational, counted
}  // namespace status

// What the gateway made of the last command or of the configuration.
enum class Answer : std::uint8_t { none, accepted, refused };

namespace refusal {  // ItemKind, position, the governor's value, the gateway's
inline constexpr std::uint8_t length = 6;
inline constexpr std::uint8_t incomplete = 0xFF;  // instead of an ItemKind: telegrams are missing
}  // namespace refusal

namespace configuration {  // index of the first item, three items
inline constexpr std::uint8_t length = 8;
inline constexpr unsigned items = 3;
inline constexpr std::uint8_t end_length = 4;  // sequence, number of items, boot number
}  // namespace configuration

}  // namespace cgw::link
