// The eight bytes of an expedited SDO, as server and client build and read them (CiA 301, 7.2.4).
#pragma once

#include <cstdint>

#include "frame/frame.hpp"
#include "object/vocabulary.hpp"
#include "wire/little_endian.hpp"

namespace cgw::canopen::sdo {

inline constexpr std::uint8_t frame_length = 8;

// Command bytes. Downloads and upload answers carry size bits below.
inline constexpr std::uint8_t download_request = 0x20;
inline constexpr std::uint8_t download_mask = 0xF0;  // 2xh: bits 3..0 are n, n, e, s
inline constexpr std::uint8_t download_answer = 0x60;
inline constexpr std::uint8_t upload_request = 0x40;
inline constexpr std::uint8_t upload_answer = 0x40;
inline constexpr std::uint8_t expedited_answer = 0x42;  // 4xh with e set
inline constexpr std::uint8_t expedited_answer_mask = 0xF2;
inline constexpr std::uint8_t abort = 0x80;
inline constexpr std::uint8_t size_stated = 0x01;
inline constexpr std::uint8_t expedited = 0x02;
inline constexpr std::uint8_t unused_shift = 2;
inline constexpr std::uint8_t unused_mask = 0x03;
inline constexpr std::uint8_t expedited_maximum = 4;  // bytes

struct Multiplexer {
    std::uint16_t index = 0;
    std::uint8_t sub_index = 0;

    friend bool operator==(const Multiplexer&, const Multiplexer&) = default;
};

inline Multiplexer multiplexer(const frame::Frame& frame) {
    return {wire::load_u16(&frame.data[1]), frame.data[3]};
}

inline std::uint32_t payload(const frame::Frame& frame) {
    return wire::load_u32(&frame.data[4]);
}

// Command byte of an expedited transfer of `length` (1..4) bytes.
constexpr std::uint8_t expedited_command(std::uint8_t command, std::uint8_t length) {
    const auto unused = static_cast<std::uint8_t>((expedited_maximum - length) << unused_shift);
    return static_cast<std::uint8_t>(command | unused | expedited | size_stated);
}

inline frame::Frame make_frame(std::uint32_t id, std::uint8_t command, Multiplexer object,
                               std::uint32_t payload) {
    frame::Frame frame;
    frame.id = id;
    frame.length = frame_length;
    frame.data[0] = command;
    wire::store_u16(&frame.data[1], object.index);
    frame.data[3] = object.sub_index;
    wire::store_u32(&frame.data[4], payload);
    return frame;
}

// A frame an SDO may be: anything else is ignored (D58).
constexpr bool well_formed(const frame::Frame& frame) {
    return frame.length == frame_length && !frame.remote && !frame.extended;
}

}  // namespace cgw::canopen::sdo
