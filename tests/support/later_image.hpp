// Images taken apart and put together otherwise, as a later minor version may have them.
#pragma once

#include <vector>

#include "support/image_bytes.hpp"

namespace cgw::test {

// A section by itself.
struct Part {
    std::uint16_t id = 0;
    std::size_t record_size = 1;
    base::Bytes bytes;
};

inline std::vector<Part> parts_of(const base::Bytes& bytes) {
    std::vector<Part> parts;
    for (std::uint16_t id = 1; id < image::section_ids; ++id) {
        const auto section = static_cast<image::SectionId>(id);
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(offset_of(bytes, section));
        parts.push_back({id, wire::load_u16(&bytes[entry_of(section) + image::directory::record_size]),
                         base::Bytes(from, from + static_cast<std::ptrdiff_t>(size_of(bytes, section)))});
    }
    return parts;
}

// Every record `more` bytes longer, filled with FFh.
inline void lengthen(Part& part, std::size_t more) {
    base::Bytes longer;
    for (std::size_t at = 0; at < part.bytes.size(); at += part.record_size) {
        const auto from = part.bytes.begin() + static_cast<std::ptrdiff_t>(at);
        longer.insert(longer.end(), from, from + static_cast<std::ptrdiff_t>(part.record_size));
        longer.insert(longer.end(), more, 0xFF);
    }
    part.bytes = longer;
    part.record_size += more;
}

inline base::Bytes join(const base::Bytes& old, const std::vector<Part>& parts, std::uint16_t minor,
                        std::size_t header_size) {
    base::Bytes bytes(old.begin(), old.begin() + image::header::size);
    bytes.resize(header_size, 0xFF);
    bytes.resize(header_size + parts.size() * image::directory::entry_size);
    std::size_t entry = header_size;
    for (const Part& part : parts) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        wire::store_u16(&bytes[entry + image::directory::id], part.id);
        wire::store_u16(&bytes[entry + image::directory::record_size],
                        static_cast<std::uint16_t>(part.record_size));
        wire::store_u32(&bytes[entry + image::directory::offset], static_cast<std::uint32_t>(bytes.size()));
        wire::store_u32(&bytes[entry + image::directory::size],
                        static_cast<std::uint32_t>(part.bytes.size()));
        entry += image::directory::entry_size;
        bytes.insert(bytes.end(), part.bytes.begin(), part.bytes.end());
    }
    bytes.resize((bytes.size() + 3) / 4 * 4 + image::crc_size);
    wire::store_u16(&bytes[image::header::format_minor], minor);
    wire::store_u16(&bytes[image::header::header_size], static_cast<std::uint16_t>(header_size));
    wire::store_u16(&bytes[image::header::section_count], static_cast<std::uint16_t>(parts.size()));
    wire::store_u32(&bytes[image::header::total_size], static_cast<std::uint32_t>(bytes.size()));
    sign(bytes);
    return bytes;
}

// And not single bytes, which no minor version can lengthen.
inline bool is_records(const Part& part) {
    return part.record_size > 1;
}

}  // namespace cgw::test
