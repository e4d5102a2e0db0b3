// Changing an image's bytes for tests: fields by section, a right CRC-32 afterwards.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.hpp"
#include "image/image.hpp"
#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"

namespace cgw::test {

inline image::Status open(const base::Bytes& bytes) {
    image::Image image;
    return image::Image::open(bytes, image);
}

// Writes the CRC-32 that the bytes now have.
inline void sign(base::Bytes& bytes) {
    const std::size_t body = bytes.size() - image::crc_size;
    wire::store_u32(&bytes[body], wire::crc32({bytes.data(), body}));
}

// Position of the section's directory entry; the images of these tests hold every section, in order of id.
inline std::size_t entry_of(image::SectionId id) {
    return image::header::size + (static_cast<std::size_t>(id) - 1) * image::directory::entry_size;
}

inline std::size_t offset_of(const base::Bytes& bytes, image::SectionId id) {
    return wire::load_u32(&bytes[entry_of(id) + image::directory::offset]);
}

inline std::size_t size_of(const base::Bytes& bytes, image::SectionId id) {
    return wire::load_u32(&bytes[entry_of(id) + image::directory::size]);
}

// A copy with `width` bytes at `position` replaced, little-endian, and signed.
inline base::Bytes changed(base::Bytes bytes, std::size_t position, std::size_t width, std::uint64_t value) {
    for (std::size_t i = 0; i < width; ++i) {
        bytes[position + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
    sign(bytes);
    return bytes;
}

}  // namespace cgw::test
