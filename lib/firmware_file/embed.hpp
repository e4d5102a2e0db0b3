// Putting a configuration image into a firmware file.
#pragma once

#include <string>

#include "firmware_file/find_image.hpp"
#include "image/image.hpp"

namespace cgw::firmware_file {

struct EmbedOptions {
    Target target;
    unsigned alignment = 8;  // bytes, a power of two
    std::uint8_t fill =
        0xFF;             // behind the image; at an address also what an area is filled with that is free
    bool beside = false;  // a new place may be taken although an image stands elsewhere
};

enum class Replaced {
    nothing,   // the file had no bytes there
    reserved,  // all of them one value
    image,     // an earlier image
};

struct Embedded {
    base::Bytes file;           // the new firmware file
    std::uint64_t address = 0;  // where the image begins
    std::uint64_t size = 0;     // bytes that were written, image and filling
    Replaced replaced = Replaced::nothing;
    std::string replaced_id{};  // configuration id of the earlier image, 16 hexadecimal digits
};

// The new file was read again: the image is in it and valid, and nothing else has changed (std::logic_error
// otherwise). Into a section the whole section is written; it must hold an earlier image, or 0xFF or 0x00
// throughout. At an address only an earlier image, bytes of the value `fill`, or nothing may stand. Where no
// earlier image is replaced, none may stand elsewhere in the file unless `beside`.
Outcome<Embedded> embed(std::span<const std::uint8_t> firmware, const image::Image& image,
                        const EmbedOptions& options);

}  // namespace cgw::firmware_file
