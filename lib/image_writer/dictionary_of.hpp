// The object dictionary that an image holds, for comparisons.
#pragma once

#include "dictionary/dictionary.hpp"
#include "image/image.hpp"

namespace cgw::image_writer {

// Indices, sub-indices, types, access, mapping and the values at start, node number included. No names,
// limits, object types and device information: an image has none. Identifiers of the device are in 1018h.
dictionary::Dictionary dictionary_of(const image::Image& image);

}  // namespace cgw::image_writer
