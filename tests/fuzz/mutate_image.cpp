#include <algorithm>
#include <cstring>

#include "base/sha256.hpp"
#include "fuzz/mutation.hpp"
#include "support/later_image.hpp"

namespace cgw::fuzz {
namespace {

using test::Part;

// The sections that header and directory speak of; none when one is not there.
std::vector<Part> parts_of(const base::Bytes& bytes) {
    std::vector<Part> parts;
    const std::size_t entries = wire::load_u16(&bytes[image::header::section_count]);
    const std::size_t directory = wire::load_u16(&bytes[image::header::header_size]);
    for (std::size_t i = 0; i < std::min<std::size_t>(entries, 40); ++i) {
        const std::size_t entry = directory + i * image::directory::entry_size;
        if (entry + image::directory::entry_size > bytes.size()) {
            return {};
        }
        const std::uint8_t* const at = &bytes[entry];
        const std::size_t offset = wire::load_u32(at + image::directory::offset);
        const std::size_t size = wire::load_u32(at + image::directory::size);
        if (offset > bytes.size() || size > bytes.size() - offset) {
            return {};
        }
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
        parts.push_back({wire::load_u16(at + image::directory::id),
                         wire::load_u16(at + image::directory::record_size),
                         base::Bytes(from, from + static_cast<std::ptrdiff_t>(size))});
    }
    return parts;
}

void mutate_part(Part& part, unsigned seed) {
    const std::size_t old = part.bytes.size();
    part.bytes.resize(old + 256);
    // Half of the time in place: most sections have a fixed length.
    const std::size_t limit = seed % 2 == 0 ? std::max<std::size_t>(old, 1) : part.bytes.size();
    std::size_t size = change_bytes(part.bytes.data(), old, limit, seed);
    if (limit == old) {
        size = old;
    }
    const std::size_t record = std::max<std::size_t>(part.record_size, 1);
    part.bytes.resize((size + record - 1) / record * record);
}

void sign_model(base::Bytes& bytes, const std::vector<Part>& parts) {
    for (const Part& part : parts) {
        if (part.id == static_cast<std::uint16_t>(image::SectionId::model)) {
            const base::Sha256 id = base::sha256(part.bytes);
            std::copy(id.begin(), id.end(), bytes.begin() + image::header::configuration_id);
        }
    }
}

// Header, size and CRC-32 as an image of these bytes has them.
void repair(std::uint8_t* data, std::size_t size) {
    std::copy(std::begin(image::magic), std::end(image::magic), data);
    wire::store_u16(data + image::header::format_major, image::format_major);
    wire::store_u32(data + image::header::total_size, static_cast<std::uint32_t>(size));
    wire::store_u32(data + size - image::crc_size, wire::crc32({data, size - image::crc_size}));
}

std::size_t mutate_bytes(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed,
                         bool repaired) {
    const std::size_t changed = change_bytes(data, size, limit, seed);
    if (repaired && changed >= image::minimum_size) {
        repair(data, changed);
    }
    return changed;
}

}  // namespace

std::size_t mutate_image(std::uint8_t* data, std::size_t size, std::size_t limit, unsigned seed) {
    if (seed % 4 < 2 || size < image::minimum_size) {
        return mutate_bytes(data, size, limit, seed, seed % 4 == 1);
    }
    const base::Bytes bytes(data, data + size);
    std::vector<Part> parts = parts_of(bytes);
    if (parts.empty()) {
        return mutate_bytes(data, size, limit, seed, true);
    }
    mutate_part(parts[seed / 8 % parts.size()], seed / 4);
    const std::size_t header_size =
        std::max<std::size_t>(wire::load_u16(&bytes[image::header::header_size]), image::header::size);
    base::Bytes made =
        test::join(bytes, parts, wire::load_u16(&bytes[image::header::format_minor]), header_size);
    if (seed % 16 != 2) {
        sign_model(made, parts);
        test::sign(made);
    }
    if (made.size() > limit) {
        return mutate_bytes(data, size, limit, seed, true);
    }
    std::copy(made.begin(), made.end(), data);
    return made.size();
}

}  // namespace cgw::fuzz
