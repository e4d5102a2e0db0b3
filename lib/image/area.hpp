// An image in an area that is reserved for one and larger than it, as `cgw image embed` leaves it. Neither
// function says whether an image is valid: give the bytes to Image::open().
#pragma once

#include <cstdint>
#include <span>

namespace cgw::image {

// As many bytes as the image at the beginning of the area says it has; none where no image begins or it would
// be longer than the area.
std::span<const std::uint8_t> stated_image(std::span<const std::uint8_t> area);

// For firmware: what Image::open() is to judge. The stated image; nothing (too_small) where the area is
// erased, all 0xFF or all 0x00; else, where its beginning is damaged, as much of the area as an image can
// have, which open() refuses with the fitting code.
std::span<const std::uint8_t> image_in(std::span<const std::uint8_t> area);

}  // namespace cgw::image
