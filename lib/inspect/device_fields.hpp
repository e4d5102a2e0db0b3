// The fields of the sections about devices and buses; part of the table of fields.hpp. Private to the room.
#pragma once

#include <iterator>

#include "facts/gateway.hpp"
#include "facts/identifiers.hpp"
#include "image/image.hpp"
#include "inspect/fields.hpp"

namespace cgw::inspect {

inline constexpr Range flag_range{0, 1};
inline constexpr Range hzm_node_range{1, facts::maximum_hzm_node};
inline constexpr Range start_up_delay_range{0, 100'000};

inline constexpr NamedValue bit_rates[] = {{0}, {125}, {250}, {500}, {1000}};

inline constexpr std::string_view registers[] = {"prescaler", "jump_width", "sampling",
                                                 "phase_1",   "phase_2",    "propagation"};

inline constexpr Field identity_fields[] = {
    {"vendor", image::identity::vendor, Type::u32, "1018h:1", {}, {}, 1, Shown::hexadecimal},
    {"product", image::identity::product, Type::u32, "1018h:2", {}, {}, 1, Shown::hexadecimal},
    {"revision", image::identity::revision, Type::u32, "1018h:3 (D32)", {}, {}, 1, Shown::hexadecimal},
    {"serial", image::identity::serial, Type::u32, "1018h:4 (D32)", {}, {}, 1, Shown::hexadecimal},
};

inline constexpr Field bus_fields[] = {
    {.name = "own_node",
     .offset = image::bus::own_node,
     .meaning = "the gateway's node",
     .note = "on CAN1 at most 31",
     .source = "401 / 427",
     .range = Range{1, facts::maximum_node_id}},
    {.name = "peer_node",
     .offset = image::bus::peer_node,
     .meaning = "the other end's node",
     .note = "on CAN1 the governor, on CAN2 the partner, 0 for none",
     .source = "402 / 428",
     .range = Range{0, facts::maximum_node_id}},
    {.name = "manual_timing",
     .offset = image::bus::manual_timing,
     .meaning = "1: registers hold",
     .note = "0: the bit rate",
     .source = "4416 / 4426",
     .range = flag_range},
    {.name = "reserved", .offset = image::bus::reserved, .meaning = "0", .shown = Shown::reserved},
    {.name = "bit_rate_kbit",
     .offset = image::bus::bit_rate_kbit,
     .type = Type::u16,
     .meaning = "kbit/s",
     .note = "0 only with manual timing",
     .source = "416 / 426",
     .values = bit_rates},
    {.name = "registers",
     .offset = image::bus::registers,
     .meaning = "bit-timing registers",
     .note =
         "prescaler 0..63, jump width 0..3, sampling 0..1, phase 1, phase 2 and propagation 0..7, as typed",
     .source = "410..415 / 420..425",
     .count = 6,
     .elements = registers},
    {.name = "start_up_delay_ms",
     .offset = image::bus::start_up_delay_ms,
     .type = Type::u32,
     .meaning = "ms until it talks",
     .note = "0 on CAN2",
     .source = "400",
     .range = start_up_delay_range},
};

inline constexpr Field governor_fields[] = {
    {.name = "own_node",
     .offset = image::governor::own_node,
     .meaning = "the governor's node",
     .source = "401",
     .range = hzm_node_range},
    {.name = "gateway_node",
     .offset = image::governor::gateway_node,
     .meaning = "the gateway's node",
     .source = "403",
     .range = hzm_node_range},
    {.name = "manual_timing",
     .offset = image::governor::manual_timing,
     .meaning = "1: registers hold",
     .source = "4416",
     .range = flag_range},
    {.name = "send_errors",
     .offset = image::governor::send_errors,
     .meaning = "1: TPDO1, 2 sent",
     .source = "14401",
     .range = flag_range},
    {.name = "bit_rate_kbit",
     .offset = image::governor::bit_rate_kbit,
     .type = Type::u16,
     .meaning = "kbit/s",
     .note = "0 only with manual timing",
     .source = "416",
     .values = bit_rates},
    {.name = "registers",
     .offset = image::governor::registers,
     .meaning = "bit-timing registers",
     .note = "as in `buses`; the governor has no propagation segment",
     .source = "410..414",
     .count = 5,
     .elements = std::span(registers).first<5>()},
    {.name = "reserved", .offset = image::governor::reserved, .meaning = "0", .shown = Shown::reserved},
    {.name = "start_up_delay_ms",
     .offset = image::governor::start_up_delay_ms,
     .type = Type::u32,
     .meaning = "ms until it talks",
     .source = "400",
     .range = start_up_delay_range},
    {.name = "main_cycle_us",
     .offset = image::governor::main_cycle_us,
     .type = Type::u32,
     .meaning = "main cycle of the governor",
     .note = "µs",
     .shown = Shown::microseconds,
     .range = Range{1, 0xFFFF'FFFF}},
    {.name = "send_status",
     .offset = image::governor::send_status,
     .meaning = "1: TPDO3 sent",
     .source = "14402",
     .range = flag_range},
    {.name = "reserved_2",
     .offset = image::governor::reserved_2,
     .meaning = "0",
     .count = 3,
     .shown = Shown::reserved},
};

inline constexpr Field heartbeat_fields[] = {
    {.name = "producer_us",
     .offset = image::heartbeat::producer_us,
     .type = Type::u32,
     .meaning = "own heartbeat, 0: off",
     .note = "effective period (D8), whole gateway cycles of 16000 µs, at most 4095",
     .source = "429",
     .shown = Shown::microseconds},
    {.name = "consumer_us",
     .offset = image::heartbeat::consumer_us,
     .type = Type::u32,
     .meaning = "monitoring time, 0: off",
     .note = "effective, likewise",
     .source = "430",
     .shown = Shown::microseconds},
    {.name = "consumer_node",
     .offset = image::heartbeat::consumer_node,
     .meaning = "the partner, 0: none",
     .source = "428",
     .range = Range{0, facts::maximum_node_id}},
    {.name = "reserved",
     .offset = image::heartbeat::reserved,
     .meaning = "0",
     .count = 3,
     .shown = Shown::reserved},
};

}  // namespace cgw::inspect
