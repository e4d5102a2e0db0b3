// Where the parts of an image are, as far as header and directory can be believed. Private to the room.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "inspect/fields.hpp"

namespace cgw::inspect {

struct Extent {
    std::uint16_t id = 0;
    std::uint16_t record_size = 0;
    std::size_t offset = 0;
    std::size_t size = 0;            // bytes that are there, which may be fewer than stated
    const Record* record = nullptr;  // nullptr: a section of a later minor

    std::size_t count() const { return record_size == 0 ? 0 : size / record_size; }
};

struct Outline {
    std::span<const std::uint8_t> bytes;
    bool known_minor = true;
    bool readable = false;  // magic and major fit: what follows the header is worth reading
    std::size_t header_size = image::header::size;
    std::size_t entries = 0;       // of the directory, that are there
    std::size_t crc_offset = 0;    // bytes.size() or more: there is none
    std::vector<Extent> sections;  // whose place can be believed, in order

    const Extent* find(image::SectionId id) const;  // nullptr: not there
    // The record's bytes, or nothing.
    std::span<const std::uint8_t> record(image::SectionId id, std::size_t position) const;
};

Outline outline_of(std::span<const std::uint8_t> bytes);

// The name of the label with this number, "" without one. Damaged labels give "".
std::string label_name(const Outline& outline, std::uint16_t number);

// A number of 1, 2 or 4 bytes at `offset`; 0 where the bytes end before.
std::uint32_t load(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t width);

inline std::size_t align_up(std::size_t offset) {
    return (offset + 3U) & ~std::size_t{3U};
}

}  // namespace cgw::inspect
