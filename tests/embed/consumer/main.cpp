// Verifies the embedded image and prints its configuration id, the way a firmware would before it uses it.
#include <cstdint>
#include <cstdio>

#include "image/image.hpp"

extern "C" {
extern const unsigned char plant_image[];
extern const unsigned int plant_image_size;
}

int main() {
    cgw::image::Image image;
    const auto status = cgw::image::Image::open({plant_image, plant_image_size}, image);
    if (status != cgw::image::Status::ok) {
        std::printf("refused, status %u\n", static_cast<unsigned>(status));
        return 1;
    }
    for (const std::uint8_t byte : image.configuration_id().first(8)) {
        std::printf("%02x", byte);
    }
    std::printf(" aligned %d\n", reinterpret_cast<std::uintptr_t>(plant_image) % 64 == 0 ? 1 : 0);
    return 0;
}
