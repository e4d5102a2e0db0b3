// What a valid image holds, as text. The image must have been opened.
#pragma once

#include <string>

#include "image/image.hpp"

namespace cgw::cli {

// `FILE: valid, format 1.0, 4128 bytes, configuration id 0123456789abcdef, CRC 89abcdef`
std::string image_summary(const std::string& path, const image::Image& image);

// Several lines of at most 80 characters; a line that would be longer (because of the path or a name) is cut.
std::string image_for_people(const std::string& path, const image::Image& image);

// One JSON document with format_version 1; later versions only gain keys.
std::string image_as_json(const std::string& path, const image::Image& image);

// Shared by the two: "TPDO4", "0.1.0", and a label's name, unit or "".
std::string pdo_name(const image::Pdo& pdo);
std::string tool_version_text(const image::Image& image);
std::string title_of(const image::Image& image);
std::string name_of(const image::Image& image, std::uint16_t number);

}  // namespace cgw::cli
