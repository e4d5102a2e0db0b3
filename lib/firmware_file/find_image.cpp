#include "firmware_file/find_image.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostic/rules/firmware.hpp"
#include "image/area.hpp"
#include "image/layout.hpp"
#include "wire/crc32.hpp"
#include "wire/little_endian.hpp"

namespace cgw::firmware_file {
namespace {

constexpr std::size_t most_places = 64;  // each costs a CRC-32 over up to 64 KiB

// The bytes of an image that ends before it says. Programs that read images hold the four letters too, so the
// whole header must make sense, as far as every version of the format has it.
std::span<const std::uint8_t> cut_image(std::span<const std::uint8_t> bytes) {
    namespace header = image::header;
    if (bytes.size() < header::size) {
        return {};
    }
    const std::size_t header_size = wire::load_u16(&bytes[header::header_size]);
    const std::size_t directory =
        wire::load_u16(&bytes[header::section_count]) * image::directory::entry_size;
    const std::size_t total = wire::load_u32(&bytes[header::total_size]);
    const bool sensible = wire::load_u16(&bytes[header::format_major]) != 0 && header_size >= header::size &&
                          header_size % 4 == 0 && directory != 0 && total % 4 == 0 &&
                          total <= image::maximum_size && header_size + directory + image::crc_size <= total;
    return sensible && total > bytes.size() ? bytes : std::span<const std::uint8_t>{};
}

}  // namespace

std::size_t intact_size(std::span<const std::uint8_t> bytes) {
    const std::span<const std::uint8_t> stated = image::stated_image(bytes);
    if (stated.empty()) {
        return 0;
    }
    const std::size_t body = stated.size() - image::crc_size;
    return wire::crc32(stated.first(body)) == wire::load_u32(&stated[body]) ? stated.size() : 0;
}

Outcome<Area> image_at(const FirmwareFile& file, const Target& target) {
    Outcome<Area> area = target.section.empty() ? file.from(target.address) : file.section(target.section);
    if (!area) {
        return area;
    }
    if (area->bytes.empty()) {
        return refuse(diagnostic::rules::firmware_address,
                      fmt::format("the file has nothing at {}", address_text(area->address)));
    }
    area->bytes = image::image_in(area->bytes);
    return area;
}

Outcome<std::vector<Area>> find_images(const FirmwareFile& file) {
    std::vector<Area> found;
    for (const Area& area : file.areas()) {
        std::span<const std::uint8_t> rest = area.bytes;
        while (true) {
            const auto next =
                std::search(rest.begin(), rest.end(), std::begin(image::magic), std::end(image::magic));
            rest = rest.subspan(static_cast<std::size_t>(next - rest.begin()));
            if (rest.empty()) {
                break;
            }
            const std::span<const std::uint8_t> stated = image::stated_image(rest);
            const std::span<const std::uint8_t> there = stated.empty() ? cut_image(rest) : stated;
            if (!there.empty()) {
                if (found.size() == most_places) {
                    return refuse(diagnostic::rules::firmware_address,
                                  fmt::format("more than {} places look like an image", most_places), {},
                                  "say where with --address");
                }
                found.push_back({area.end() - rest.size(), there});
            }
            const std::size_t intact = intact_size(rest);
            rest = rest.subspan(intact != 0 ? intact : sizeof image::magic);
        }
    }
    return found;
}

}  // namespace cgw::firmware_file
