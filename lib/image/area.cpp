#include "image/area.hpp"

#include "image/layout.hpp"
#include "wire/little_endian.hpp"
#include "wire/search.hpp"

namespace cgw::image {

std::span<const std::uint8_t> stated_image(std::span<const std::uint8_t> area) {
    if (area.size() < minimum_size) {
        return {};
    }
    for (std::size_t i = 0; i < sizeof magic; ++i) {
        if (area[i] != magic[i]) {
            return {};
        }
    }
    const std::size_t size = wire::load_u32(&area[header::total_size]);
    const std::size_t header_size = wire::load_u16(&area[header::header_size]);
    const bool sensible = size >= minimum_size && size <= maximum_size && size <= area.size() &&
                          header_size >= header::size && header_size < size;
    return sensible ? area.first(size) : std::span<const std::uint8_t>{};
}

std::span<const std::uint8_t> image_in(std::span<const std::uint8_t> area) {
    const std::span<const std::uint8_t> stated = stated_image(area);
    if (!stated.empty() || wire::all_are(area, 0xFF) || wire::all_are(area, 0x00)) {
        return stated;
    }
    return area.first(area.size() < maximum_size ? area.size() : maximum_size);
}

}  // namespace cgw::image
