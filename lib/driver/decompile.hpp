// A configuration image back to a parameter file, and what that file compiles to.
#pragma once

#include <string>
#include <vector>

#include "driver/check_file.hpp"
#include "image/image.hpp"

namespace cgw::driver {

struct DecompiledImage {
    std::string text;               // the parameter file; its first comments say what is lost
    std::vector<std::string> lost;  // what the image does not say, a phrase each
    CheckedFile file;               // of the text
    std::string new_id;             // configuration id of the file, 16 digits
    bool exact = false;             // from the canonical model
    // Parts in which the image made of the file is another: "configuration id", "labels", …; meaningful when
    // the file is valid(). The version of cgw and the CRC-32 that follows from it are not counted.
    std::vector<std::string> differing;
    bool other_version = false;  // only the version of cgw that wrote the image is another

    bool identical() const { return file.valid() && differing.empty(); }
    // A gateway with the new image behaves as with the old one: at most id, labels and model differ.
    bool works_alike() const;
};

// `path` is what findings call the text; its directory is where nothing is looked for.
DecompiledImage decompile(const image::Image& image, const std::string& path);

}  // namespace cgw::driver
