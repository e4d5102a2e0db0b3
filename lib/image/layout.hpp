// The configuration image, format 1: one table of what stands where. docs/image-format.md tells the same
// in prose. All numbers little-endian; sections begin at multiples of 4; gaps are zero.
//
//   header (64 bytes) · section directory · sections · CRC-32 over everything before it (last 4 bytes)
//
// Sections follow each other without a gap but the zero bytes that align the next one (and the CRC-32).
// Bytes named `reserved` are 0 in this minor; a later one may use them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cgw::image {

inline constexpr std::uint8_t magic[4] = {'C', 'G', 'W', 'I'};
inline constexpr std::uint16_t format_major = 1;  // another major is refused
inline constexpr std::uint16_t format_minor = 0;  // a higher minor is accepted: it only adds

namespace header {
inline constexpr std::size_t magic = 0;              // 4 bytes
inline constexpr std::size_t format_major = 4;       // u16
inline constexpr std::size_t format_minor = 6;       // u16
inline constexpr std::size_t header_size = 8;        // u16, 64 in minor 0
inline constexpr std::size_t section_count = 10;     // u16
inline constexpr std::size_t total_size = 12;        // u32, CRC included
inline constexpr std::size_t configuration_id = 16;  // 32 bytes, SHA-256 of the canonical model
inline constexpr std::size_t configuration_id_size = 32;
inline constexpr std::size_t tool_version = 48;  // u16 major, minor, patch of the cgw that wrote it
inline constexpr std::size_t reserved = 54;      // 10 bytes, 0
inline constexpr std::size_t size = 64;
}  // namespace header

namespace directory {                          // one entry per section, ascending id and offset
inline constexpr std::size_t id = 0;           // u16
inline constexpr std::size_t record_size = 2;  // u16; a later minor may lengthen a record at its end
inline constexpr std::size_t offset = 4;       // u32, from the image's first byte
inline constexpr std::size_t size = 8;         // u32, bytes; a multiple of record_size
inline constexpr std::size_t entry_size = 12;
}  // namespace directory

inline constexpr std::size_t crc_size = 4;
inline constexpr std::size_t minimum_size = header::size + crc_size;
inline constexpr std::size_t maximum_size = 64U * 1024U;

enum class SectionId : std::uint16_t {
    identity = 1,
    buses = 2,
    governor = 3,
    heartbeat = 4,
    pdos = 5,
    objects = 6,
    object_values = 7,
    switches = 8,
    sensors = 9,
    signals = 10,
    labels = 11,   // optional
    strings = 12,  // optional, goes with labels
    model = 13,    // optional, only where labels are: the text whose SHA-256 is the configuration id
};
inline constexpr std::size_t section_ids = 14;  // one more than the highest id

namespace identity {  // one record: object 1018h
inline constexpr std::size_t vendor = 0, product = 4, revision = 8, serial = 12, size = 16;  // u32 each
}

namespace bus {                                       // two records: CAN1 (governor side), CAN2 (CANopen)
inline constexpr std::size_t own_node = 0;            // u8: 401 / 427
inline constexpr std::size_t peer_node = 1;           // u8: 402 / 428, 0 none
inline constexpr std::size_t manual_timing = 2;       // u8, 0 or 1: 4416 / 4426
inline constexpr std::size_t reserved = 3;            // u8, 0
inline constexpr std::size_t bit_rate_kbit = 4;       // u16: 416 / 426; may be 0 when the timing is manual
inline constexpr std::size_t registers = 6;           // 6 × u8: 410..415 / 420..425
inline constexpr std::size_t start_up_delay_ms = 12;  // u32: 400; 0 for CAN2
inline constexpr std::size_t size = 16;
}  // namespace bus

namespace governor {                                  // one record: the governor's half
inline constexpr std::size_t own_node = 0;            // u8: 401
inline constexpr std::size_t gateway_node = 1;        // u8: 403
inline constexpr std::size_t manual_timing = 2;       // u8
inline constexpr std::size_t send_errors = 3;         // u8: 14401
inline constexpr std::size_t bit_rate_kbit = 4;       // u16: 416
inline constexpr std::size_t registers = 6;           // 5 × u8: 410..414
inline constexpr std::size_t reserved = 11;           // u8, 0
inline constexpr std::size_t start_up_delay_ms = 12;  // u32: 400
inline constexpr std::size_t main_cycle_us = 16;      // u32
inline constexpr std::size_t send_status = 20;        // u8: 14402
inline constexpr std::size_t reserved_2 = 21;         // 3 × u8, 0
inline constexpr std::size_t size = 24;
}  // namespace governor

namespace heartbeat {                                           // one record, effective times
inline constexpr std::size_t producer_us = 0, consumer_us = 4;  // u32, 0 off
inline constexpr std::size_t consumer_node = 8;                 // u8: 428, 0 none
inline constexpr std::size_t reserved = 9;                      // 3 × u8, 0
inline constexpr std::size_t size = 12;
}  // namespace heartbeat

namespace pdo {                                      // twenty records: TPDO1..16, RPDO1..4
inline constexpr std::size_t direction = 0;          // u8: 0 transmit, 1 receive
inline constexpr std::size_t number = 1;             // u8
inline constexpr std::size_t active = 2;             // u8, 0 or 1
inline constexpr std::size_t cob_id_source = 3;      // u8: 0 predefined, 1 parameter
inline constexpr std::size_t cob_id = 4;             // u16, without bit 31
inline constexpr std::size_t word_count = 6;         // u8, 0..4
inline constexpr std::size_t transmission_type = 7;  // u8
inline constexpr std::size_t effective_us = 8;       // u32
inline constexpr std::size_t asked_ms = 12;          // u16
inline constexpr std::size_t cycles = 14;            // u16
inline constexpr std::size_t mapping = 16;           // 4 × u32: index << 16 | sub << 8 | bits, 0 unused
inline constexpr std::size_t parameters = 32;        // 4 × u16: source parameter of the word, 0 none
inline constexpr std::size_t size = 40;
inline constexpr std::size_t count = 20;
}  // namespace pdo

// objects: the records of object/object_table.hpp, which reads and writes them, sorted by index and
// sub-index. object_values: the value block at start; first all 4-byte values, then all 2-byte, then all
// 1-byte values, each in the order of the object table, so that every value is aligned to its own size.
namespace object_record {
inline constexpr std::size_t index = 0;      // u16
inline constexpr std::size_t sub_index = 2;  // u8
inline constexpr std::size_t type = 3;       // u8
inline constexpr std::size_t rights = 4;     // u8: access in bits 0..3, flags in bits 4..7
inline constexpr std::size_t handler = 5;    // u8, 0
inline constexpr std::size_t offset = 6;     // u16, of the value in the value block
inline constexpr std::size_t size = 8;
}  // namespace object_record

namespace switch_function {                   // one record each, ascending number
inline constexpr std::size_t number = 0;      // u16: 8nn
inline constexpr std::size_t bit = 2;         // u8: 1..16
inline constexpr std::size_t low_active = 3;  // u8: 0 or 1
inline constexpr std::size_t size = 4;
}  // namespace switch_function

namespace sensor {                          // one record each, ascending number
inline constexpr std::size_t number = 0;    // u16: 9nn
inline constexpr std::size_t channel = 2;   // u8: 1..12
inline constexpr std::size_t reserved = 3;  // u8, 0
inline constexpr std::size_t size = 4;
}  // namespace sensor

// One record per parameter that a TPDO word or a sensor carries, ascending number, each once.
namespace signal {
inline constexpr std::size_t number = 0;            // u16: measurement, or 9nn
inline constexpr std::size_t width = 2;             // u8: 8 or 16
inline constexpr std::size_t is_signed = 3;         // u8
inline constexpr std::size_t internal_minimum = 4;  // u16, or i16 when is_signed
inline constexpr std::size_t internal_maximum = 6;  // likewise
inline constexpr std::size_t size = 8;
}  // namespace signal

namespace label {  // names for displays, ascending number; number 0 is the file's title
inline constexpr std::size_t number = 0;             // u16
inline constexpr std::size_t name_length = 2;        // u8
inline constexpr std::size_t unit_length = 3;        // u8
inline constexpr std::size_t name_offset = 4;        // u32, into the strings section
inline constexpr std::size_t unit_offset = 8;        // u32
inline constexpr std::size_t has_scaling = 12;       // u8, 0 or 1
inline constexpr std::size_t reserved = 13;          // 3 × u8, 0
inline constexpr std::size_t external_minimum = 16;  // f64 (IEEE 754 bits), for the signal's internal minimum
inline constexpr std::size_t external_maximum = 24;  // f64
inline constexpr std::size_t size = 32;
}  // namespace label

}  // namespace cgw::image
