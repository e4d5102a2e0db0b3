#pragma once

#include <string>

#include "image/image.hpp"

namespace cgw::runtime {

// First 8 bytes of the image's configuration id in hexadecimal digits, as everywhere.
std::string configuration_id_text(const image::Image& image);

}  // namespace cgw::runtime
