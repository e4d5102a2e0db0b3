#include "firmware_file/embed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/sha256.hpp"
#include "diagnostic/rules/firmware.hpp"
#include "image/area.hpp"

namespace cgw::firmware_file {
namespace {

namespace rules = diagnostic::rules;

// What the image will cover, and what is there now.
struct Room {
    Area present;  // from the beginning to the end of section or segment; of records, what stands there
    std::uint64_t size = 0;   // bytes that will be written
    std::size_t earlier = 0;  // of them, those of an earlier image
};

Outcome<Room> room_in_section(const FirmwareFile& file, std::string_view name, std::size_t image_size) {
    const Outcome<Area> section = file.section(name);
    if (!section) {
        return tl::unexpected(section.error());
    }
    if (image_size > section->bytes.size()) {
        return refuse(rules::image_room, fmt::format("section {} has {} bytes, the image needs {}", name,
                                                     section->bytes.size(), image_size));
    }
    return Room{*section, section->bytes.size(), intact_size(section->bytes)};
}

Outcome<Room> room_at_address(const FirmwareFile& file, std::uint64_t address, std::size_t image_size) {
    const Outcome<Area> present = file.from(address);
    if (!present) {
        return tl::unexpected(present.error());
    }
    if (file.kind() == Kind::elf) {
        if (present->bytes.empty()) {
            return refuse(rules::firmware_address,
                          fmt::format("no loaded segment has contents at {}", address_text(address)), {},
                          "reserve the area in the program, as a section of read-only data");
        }
        if (image_size > present->bytes.size()) {
            return refuse(rules::image_room,
                          fmt::format("the segment has {} bytes from {} on, the image needs {}",
                                      present->bytes.size(), address_text(address), image_size));
        }
    } else if (address > address_limit || image_size > address_limit - address) {
        return refuse(rules::firmware_address,
                      fmt::format("at {} the image would end beyond 32 bits", address_text(address)));
    }
    const std::size_t earlier = intact_size(present->bytes);
    return Room{*present, std::max(image_size, earlier), earlier};
}

// Behind the earlier image only bytes of one value may be covered.
Outcome<Replaced> replaceable(const FirmwareFile& file, const Room& room, const EmbedOptions& options) {
    const std::uint64_t begin = room.present.address + room.earlier;
    const std::uint64_t end = room.present.address + room.size;
    std::uint8_t filling = options.fill;
    if (!options.target.section.empty() && room.earlier < room.size &&
        room.present.bytes[room.earlier] == 0) {
        filling = 0;
    } else if (!options.target.section.empty()) {
        filling = 0xFF;
    }
    bool covers = false;
    for (const Area& area : file.areas()) {
        const std::uint64_t first = std::max(begin, area.address);
        const std::uint64_t last = std::min(end, area.end());
        if (first >= last) {
            continue;
        }
        covers = true;
        const std::span<const std::uint8_t> bytes = area.bytes.subspan(first - area.address, last - first);
        const auto data =
            std::find_if(bytes.begin(), bytes.end(), [&](std::uint8_t b) { return b != filling; });
        if (data != bytes.end()) {
            const std::uint64_t where = first + static_cast<std::uint64_t>(data - bytes.begin());
            const bool begun = room.earlier == 0 && !image::stated_image(room.present.bytes).empty();
            if (begun) {
                return refuse(rules::image_occupied,
                              fmt::format("the image at {} is damaged: its CRC-32 does not fit",
                                          address_text(room.present.address)),
                              {}, "take the firmware as it was built");
            }
            return refuse(
                rules::image_occupied,
                fmt::format("the byte at {} is 0x{:02X}: the area is not free, and no image stands there",
                            address_text(where), *data),
                {},
                options.target.section.empty()
                    ? "leave the area out of the firmware, or fill it with 0xFF (0x00 with --fill 0x00)"
                    : "fill the section with 0xFF or 0x00 throughout");
        }
    }
    if (room.earlier != 0) {
        return Replaced::image;
    }
    return covers ? Replaced::reserved : Replaced::nothing;
}

// A new place beside an image that the program may go on using is hardly meant.
Outcome<void> alone(const FirmwareFile& file, const Room& room) {
    const Outcome<std::vector<Area>> images = find_images(file);
    if (!images) {
        return refuse(images.error().rule == nullptr ? rules::firmware_address : *images.error().rule,
                      images.error().message, {}, "--beside does not look for other images");
    }
    for (const Area& image : *images) {
        const bool here =
            image.address < room.present.address + room.size && room.present.address < image.end();
        if (!here && intact_size(image.bytes) != 0) {
            return refuse(rules::image_elsewhere,
                          fmt::format("an image stands at {} already, configuration id {}, and none at {}",
                                      address_text(image.address),
                                      base::short_id(image.bytes.subspan(image::header::configuration_id)),
                                      address_text(room.present.address)),
                          {}, "replace that one, or say --beside where the firmware is to have both");
        }
    }
    return {};
}

// Of a file that was read: what it says beside the bytes at their addresses.
std::vector<std::string> other_records(Kind kind, std::span<const std::uint8_t> file) {
    switch (kind) {
        case Kind::intel_hex:
            return other_intel_hex_records(file);
        case Kind::s_record:
            return other_s_records(file);
        case Kind::elf:
            break;
    }
    return {};
}

void prove(const Embedded& embedded, std::span<const std::uint8_t> firmware, const FirmwareFile& before,
           const image::Image& image) {
    const Outcome<FirmwareFile> after = FirmwareFile::read(embedded.file);
    if (!after) {
        throw std::logic_error("the new firmware file cannot be read: " + after.error().message);
    }
    const Outcome<Area> found = image_at(*after, {"", embedded.address});
    image::Image read;
    if (!found || image::Image::open(found->bytes, read) != image::Status::ok ||
        !std::equal(found->bytes.begin(), found->bytes.end(), image.bytes().begin(), image.bytes().end())) {
        throw std::logic_error("the image is not in the new firmware file");
    }
    if (!after->same_outside(before, embedded.address, embedded.address + embedded.size)) {
        throw std::logic_error("the new firmware file differs outside the image");
    }
    if (other_records(after->kind(), embedded.file) != other_records(before.kind(), firmware)) {
        throw std::logic_error("the new firmware file has lost or changed a start or header record");
    }
}

}  // namespace

Outcome<Embedded> embed(std::span<const std::uint8_t> firmware, const image::Image& image,
                        const EmbedOptions& options) {
    Outcome<FirmwareFile> file = FirmwareFile::read(firmware);
    if (!file) {
        return tl::unexpected(file.error());
    }
    const std::size_t image_size = image.bytes().size();
    const Target& target = options.target;
    const Outcome<Room> room = target.section.empty() ? room_at_address(*file, target.address, image_size)
                                                      : room_in_section(*file, target.section, image_size);
    if (!room) {
        return tl::unexpected(room.error());
    }
    const std::uint64_t address = room->present.address;
    if (address % options.alignment != 0) {
        return refuse(rules::image_alignment,
                      fmt::format("{}, where the image would begin, is no multiple of {}",
                                  address_text(address), options.alignment));
    }
    if (const Outcome<void> allowed = file->allows(address, room->size); !allowed) {
        return tl::unexpected(allowed.error());
    }
    const Outcome<Replaced> replaced = replaceable(*file, *room, options);
    if (!replaced) {
        return tl::unexpected(replaced.error());
    }
    if (*replaced != Replaced::image && !options.beside) {
        if (const Outcome<void> only = alone(*file, *room); !only) {
            return tl::unexpected(only.error());
        }
    }
    Embedded embedded{{}, address, room->size, *replaced, {}};
    if (room->earlier != 0) {
        embedded.replaced_id = base::short_id(room->present.bytes.subspan(image::header::configuration_id));
    }
    base::Bytes bytes(room->size, options.fill);
    std::copy(image.bytes().begin(), image.bytes().end(), bytes.begin());
    const FirmwareFile before = *file;
    file->put(address, bytes);
    embedded.file = file->bytes();
    prove(embedded, firmware, before, image);
    return embedded;
}

}  // namespace cgw::firmware_file
