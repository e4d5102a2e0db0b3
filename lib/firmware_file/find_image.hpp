// Configuration images inside firmware files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "firmware_file/firmware_file.hpp"

namespace cgw::firmware_file {

// Where an image stands or is to stand: in a section of an ELF program, or at an address.
struct Target {
    std::string section;        // empty: at the address
    std::uint64_t address = 0;  // where the program sees it
};

// Bytes of the image at the beginning when its CRC-32 fits, also of one in a version that this cgw does not
// read; 0: no image, or a damaged one.
std::size_t intact_size(std::span<const std::uint8_t> bytes);

// What a gateway would judge there, as image::image_in() has it: as many bytes as the image says it has, none
// where the area is erased, else what stands there, up to the largest image. Refused when nothing stands
// there.
Outcome<Area> image_at(const FirmwareFile& file, const Target& target);

// All places that begin like an image and may hold one, in the order of the file. Of an image that is cut off
// where the bytes end, what is there; the mere letters that an image begins with are none. Refuses more than
// 64 places.
Outcome<std::vector<Area>> find_images(const FirmwareFile& file);

}  // namespace cgw::firmware_file
