// A configuration image back to a parameter file, and what that file compiles to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/check_file.hpp"
#include "image/image.hpp"

namespace cgw::driver {

struct DecompiledImage {
    std::string text;  // the parameter file; its first comments say what is lost
    // What the image does not say, or a later format says and this cgw cannot read; a phrase each.
    std::vector<std::string> lost;
    CheckedFile file;    // of the text
    std::string new_id;  // configuration id of the file, 16 digits
    bool exact = false;  // from the canonical model
    // Parts in which the image made of the file is another: "configuration id", "labels", …; meaningful when
    // the file is valid(). The version of cgw and the CRC-32 that follows from it are not counted.
    std::vector<std::string> differing;
    bool other_version = false;  // another version of cgw wrote the image
    bool labels = false;         // the image has labels; else only --no-labels makes one that is alike
    bool harmless = false;       // a gateway does not look at what differs

    bool identical() const { return file.valid() && differing.empty(); }
    // A gateway with the new image behaves as with the old one: at most id, labels and model differ.
    bool works_alike() const;
    // "It compiles" or "With --no-labels it compiles", for sentences that go on with " to the …".
    std::string_view compiles() const;
};

// `path` is what findings call the text; its directory is where nothing is looked for.
DecompiledImage decompile(const image::Image& image, const std::string& path);

}  // namespace cgw::driver
