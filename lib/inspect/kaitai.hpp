// schemas/config-image.ksy: the image as a Kaitai Struct specification, made from the table of fields.
#pragma once

#include <string>

namespace cgw::inspect {

// YAML. A reader made of it takes sound images apart; it does not verify them as image/ does.
std::string kaitai_specification();

}  // namespace cgw::inspect
