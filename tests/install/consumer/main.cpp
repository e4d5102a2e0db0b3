#include <cstdio>

#include "device/gateway.hpp"
#include "image/image.hpp"

extern "C" {
extern const unsigned char cgw_config_image[];
extern const unsigned int cgw_config_image_size;
}

int main() {
    cgw::image::Image image;
    const cgw::image::Status status =
        cgw::image::Image::open({cgw_config_image, cgw_config_image_size}, image);
    std::printf("%s, node %u\n", status == cgw::image::Status::ok ? "valid" : "refused",
                static_cast<unsigned>(image.can2().own_node));
    return status == cgw::image::Status::ok ? 0 : 1;
}
