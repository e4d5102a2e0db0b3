// One field of an image as value, meaning and what is wrong with it. Private to the room.
#pragma once

#include "inspect/annotation.hpp"
#include "inspect/outline.hpp"

namespace cgw::inspect {

// `element` of a field that stands several times; `at` is where it begins in the image, and its bytes are
// there.
Item item_of(const Outline& outline, const Field& field, std::size_t element, std::size_t record,
             std::size_t at);

// "registers[1]", or the field's name
std::string element_name(const Field& field, std::size_t element);

// Text of an image in quotes, safe to print.
std::string quoted(std::span<const std::uint8_t> text);

}  // namespace cgw::inspect
