// An image in an area that is reserved for one and larger than it, as `cgw image embed` leaves it.
#pragma once

#include <cstdint>
#include <span>

namespace cgw::image {

// The bytes that an image at the beginning of the area says it has; none where no image begins or it would be
// longer than the area. This says nothing about whether it is valid: give the bytes to Image::open().
std::span<const std::uint8_t> image_in(std::span<const std::uint8_t> area);

}  // namespace cgw::image
