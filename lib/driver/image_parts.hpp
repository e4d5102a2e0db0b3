// What tells two valid images apart, part by part. Every byte but padding and CRC-32, which follow from the
// others, belongs to a part: images without a differing part are byte for byte the same.
#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"

namespace cgw::driver {

enum class PartKind : std::uint8_t {
    version,  // of the cgw that wrote the image
    format,   // the minor
    header,   // its size, and bytes that this minor leaves to later ones
    configuration_id,
    section,        // one that this minor knows
    later_section,  // one that it does not know
};

// `a` and `b` are texts for people: "1.0", "section left out", "40 bytes".
struct PartDifference {
    PartKind kind{};
    std::string name;  // "configuration id", "labels", "section 14"
    std::string a;
    std::string b;
};

std::vector<PartDifference> differing_parts(const image::Image& a, const image::Image& b);

// What a later minor put into the image and this one cannot read, a phrase each.
std::vector<std::string> parts_of_a_later_minor(const image::Image& image);

}  // namespace cgw::driver
